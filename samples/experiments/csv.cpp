// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html

#include "csv.hpp"

#include <cmath>
#include <stdexcept>

#include <opencv2/core.hpp>

#include "common/output_file.hpp"

namespace experiments {

Csv::Csv(const std::string& folder, const std::string& name, const std::vector<std::string>& columns)
    : path_(folder + "/" + name + ".csv"), columns_(columns.size())
{
    for (const std::string& column : columns)
        *this << column;
    endRow();
}

Csv& Csv::operator<<(const std::string& cell)
{
    text_ << (cells_++ > 0 ? "," : "") << cell;
    return *this;
}

Csv& Csv::operator<<(double cell)
{
    return *this << (std::isnan(cell) ? std::string() : cv::format("%.9g", cell));
}

void Csv::endRow()
{
    if (cells_ != columns_)
        throw std::logic_error(path_ + ": a row does not fit the header");
    text_ << "\n";
    cells_ = 0;
}

void Csv::save() const
{
    files::writeFile(path_, [this](std::ostream& out) { out << text_.str(); });
}

std::vector<std::string> intervalColumns(const std::string& name)
{
    return {name, name + "_low", name + "_high"};
}

std::vector<std::string> operator+(std::vector<std::string> a, const std::vector<std::string>& b)
{
    a.insert(a.end(), b.begin(), b.end());
    return a;
}

}  // namespace experiments
