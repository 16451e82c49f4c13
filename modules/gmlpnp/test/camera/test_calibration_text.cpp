// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html

#include "../test_precomp.hpp"

#include "../../src/camera/calibration_text.hpp"
#include "../expect_error.hpp"

namespace opencv_test {
namespace {

using cv::gmlpnp::detail::calibrationText;

// No text here harms a parser: each is whole, or raises an error at most. What is tested is that the texts are stopped
// or cut before a parser sees them.

const char* const kYaml = "%YAML:1.0\n---\nK: [ 1, 2 ]\nD:\n   rows: 1\n";
const char* const kXml = "<?xml version=\"1.0\"?>\n<opencv_storage>\n<xi>1.25</xi>\n</opencv_storage>\n";

void expectRefused(const String& text, const std::string& reason)
{
    expectError(Error::StsParseError, reason, [&] { calibrationText(text); });
}

TEST(Gmlpnp_CalibrationText, wholeTextsStay)
{
    for (const char* text : {kYaml, kXml, "{ \"xi\": 1.25 }\n"}) {
        EXPECT_EQ(calibrationText(text), text);
        EXPECT_EQ(calibrationText(String("\xEF\xBB\xBF") + text), text);
    }
}

TEST(Gmlpnp_CalibrationText, yamlOfOtherProgramsIsRepaired)
{
    EXPECT_EQ(calibrationText("a: 1\n"), "%YAML:1.0\n---\na: 1\n");
    EXPECT_EQ(calibrationText("---\na: 1\n"), "%YAML:1.0\n---\na: 1\n");
    EXPECT_EQ(calibrationText("# comment\n\n  a:\t1\n"), "%YAML:1.0\n---\n  a: 1\n");
}

TEST(Gmlpnp_CalibrationText, yamlIsCutBehindItsFirstDocument)
{
    for (const char* more : {"...\n", "---\nb: 2\n", "...\n---\nb: 2\n", "...\nb: 2\n"})
        EXPECT_EQ(calibrationText(String(kYaml) + more), kYaml) << more;
}

TEST(Gmlpnp_CalibrationText, yamlThatLeavesItsMappingIsRefused)
{
    for (const char* text : {"  a: 1\nb: 2\n", "\t\ta: 1\nb: 2\n", "---\n  a: 1\nb: 2\n", "--- # a\n  a: 1\n b: 2\n",
                             "%YAML:1.0\n---\n  a: 1\n  b: 2\n\n # c\n d: 3\n"})
        expectRefused(text, "leaves its mapping");
    EXPECT_EQ(calibrationText("  a: 1\n# b\n"), "%YAML:1.0\n---\n  a: 1\n# b\n");
}

TEST(Gmlpnp_CalibrationText, yamlThatIsNoMappingIsRefused)
{
    for (const char* text :
         {"- 1\n- 2\n", "[ 1, 2 ]\n", "--- [ 1, 2 ]\n", "--- 5\n", "---\n\"a\"\n", "---\n{ a: 1 }\n"})
        expectRefused(text, "holds no mapping");
    for (const char* text : {"# a\n# b", "# a\n\n"})
        expectRefused(text, "holds nothing");
}

TEST(Gmlpnp_CalibrationText, xmlEndsWithATag)
{
    expectRefused(String(kXml) + "more", "ends too early");
    EXPECT_EQ(calibrationText(String(" \n") + kXml + "\r\n\t "), String(kXml) + "\r\n\t ");
}

TEST(Gmlpnp_CalibrationText, whatIsNoTextIsRefused)
{
    for (const String& text : {String(), String(" \n\t\r\n"), String("a: 1\0", 5)})
        expectRefused(text, "is empty or not a text file");
}

}  // namespace
}  // namespace opencv_test
