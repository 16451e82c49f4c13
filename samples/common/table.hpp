// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html

#ifndef GMLPNP_SAMPLES_TABLE_HPP
#define GMLPNP_SAMPLES_TABLE_HPP

#include <ostream>
#include <string>
#include <vector>

namespace samples {

/** Text in aligned columns: the first to the left, numbers to the right, a rule under the title row. */
class Table
{
public:
    explicit Table(const std::vector<std::string>& title) : rows_{title} {}

    //! A row may be shorter than the title row, not longer.
    void add(const std::vector<std::string>& row) { rows_.push_back(row); }

    void print(std::ostream& out) const;

    //! As a Markdown table.
    void printMarkdown(std::ostream& out) const;

private:
    std::vector<std::vector<std::string>> rows_;

    std::vector<size_t> widths() const;
};

/** A number with a fixed count of decimals: "12.30". */
std::string fixed(double value, int decimals);

/** Three numbers with a sign, aligned: "+0.01 -0.20 +3.00". */
std::string triple(double x, double y, double z, int decimals, int width = 0);

}  // namespace samples

#endif  // GMLPNP_SAMPLES_TABLE_HPP
