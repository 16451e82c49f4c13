// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html

#include "calibration_text.hpp"

#include <cctype>

namespace cv {
namespace gmlpnp {
namespace detail {
namespace {

[[noreturn]] void refuse(const char* reason)
{
    CV_Error(Error::StsParseError, reason);
}

// A line of a text file. Its content starts behind the blanks in front.
struct Line
{
    size_t begin, content, end;

    bool isEmpty(const String& text) const { return content == end || text[content] == '\r' || text[content] == '#'; }
    bool startsWith(const String& text, const char* word) const { return text.compare(content, 3, word) == 0; }
    size_t indentation() const { return content - begin; }
};

Line lineAt(const String& text, size_t begin)
{
    const size_t end = std::min(text.find('\n', begin), text.size());
    return {begin, std::min(text.find_first_not_of(' ', begin), end), end};
}

// Returns the first line from this one on that is not empty, or the last line where all are empty.
Line notEmpty(const String& text, Line line)
{
    while (line.end < text.size() && line.isEmpty(text))
        line = lineAt(text, line.end + 1);
    return line;
}

// Returns the line where the first document starts. It stands below comments and directives, and behind the mark.
Line firstContent(const String& text)
{
    Line line = notEmpty(text, lineAt(text, 0));
    while (line.end < text.size() && text[line.content] == '%')
        line = notEmpty(text, lineAt(text, line.end + 1));
    if (!line.startsWith(text, "---"))
        return line;
    line.content = std::min(text.find_first_not_of(' ', line.content + 3), line.end);
    return notEmpty(text, line);
}

// Keeps the first document alone. It must be a mapping, and no line of it may stand further to the left than its first
// line.
void keepFirstMapping(String& text)
{
    const Line first = firstContent(text);
    if (first.isEmpty(text) || !(std::isalpha(static_cast<uchar>(text[first.content])) || text[first.content] == '_'))
        refuse("holds no mapping");
    for (size_t begin = first.end + 1; begin < text.size();) {
        const Line line = lineAt(text, begin);
        begin = line.end + 1;
        if (line.isEmpty(text) || line.indentation() > first.indentation())
            continue;
        if (line.startsWith(text, "...") || line.startsWith(text, "---"))
            text.erase(line.begin);
        else if (line.indentation() < first.indentation())
            refuse("has a line that leaves its mapping");
    }
}

// Returns the YAML with its first line, without tabs and without comments above that line.
String plainYaml(String text)
{
    std::replace(text.begin(), text.end(), '\t', ' ');
    const Line first = notEmpty(text, lineAt(text, 0));
    if (first.isEmpty(text))
        refuse("holds nothing");
    text.erase(0, first.begin);  // the indentation of the first line counts
    if (text[0] != '%')
        text.insert(0, text.compare(0, 3, "---") == 0 ? "%YAML:1.0\n" : "%YAML:1.0\n---\n");
    keepFirstMapping(text);
    return text;
}

}  // namespace

String calibrationText(String text)
{
    if (text.compare(0, 3, "\xEF\xBB\xBF") == 0)
        text.erase(0, 3);
    const size_t start = text.find_first_not_of(" \t\r\n");
    if (start == String::npos || text.find('\0') != String::npos)
        refuse("is empty or not a text file");
    if (text[start] == '<' && text[text.find_last_not_of(" \t\r\n")] != '>')
        refuse("ends too early");
    return text[start] == '<' || text[start] == '{' ? text.substr(start) : plainYaml(text);
}

}  // namespace detail
}  // namespace gmlpnp
}  // namespace cv
