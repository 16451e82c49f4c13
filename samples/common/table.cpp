// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html

#include "common/table.hpp"

#include <algorithm>
#include <cstdio>

#include <opencv2/core.hpp>

namespace samples {

std::vector<size_t> Table::widths() const
{
    std::vector<size_t> widths(rows_[0].size(), 0);
    for (const auto& row : rows_)
        for (size_t c = 0; c < row.size(); ++c)
            widths[c] = std::max(widths[c], row[c].size());
    return widths;
}

void Table::print(std::ostream& out) const
{
    const std::vector<size_t> widths = this->widths();
    size_t total = 0;
    for (const size_t width : widths)
        total += width + 2;
    for (size_t r = 0; r < rows_.size(); ++r) {
        for (size_t c = 0; c < rows_[r].size(); ++c) {
            const std::string padding(widths[c] - rows_[r][c].size(), ' ');
            out << (c == 0 ? "" : "  ") << (c == 0 ? rows_[r][c] + padding : padding + rows_[r][c]);
        }
        out << "\n";
        if (r == 0)
            out << std::string(total - 2, '-') << "\n";
    }
}

void Table::printMarkdown(std::ostream& out) const
{
    const std::vector<size_t> widths = this->widths();
    for (size_t r = 0; r < rows_.size(); ++r) {
        out << "|";
        for (size_t c = 0; c < widths.size(); ++c) {
            const std::string text = c < rows_[r].size() ? rows_[r][c] : std::string();
            const std::string padding(widths[c] - text.size(), ' ');
            out << " " << (c == 0 ? text + padding : padding + text) << " |";
        }
        out << "\n";
        if (r > 0)
            continue;
        out << "|";
        for (size_t c = 0; c < widths.size(); ++c)
            out << (c == 0 ? std::string(widths[c] + 2, '-') : std::string(widths[c] + 1, '-') + ":") << "|";
        out << "\n";
    }
}

std::string fixed(double value, int decimals)
{
    return cv::format("%.*f", decimals, value);
}

std::string triple(double x, double y, double z, int decimals, int width)
{
    return cv::format("%+*.*f %+*.*f %+*.*f", width, decimals, x, width, decimals, y, width, decimals, z);
}

}  // namespace samples
