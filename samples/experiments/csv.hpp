// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html

#ifndef GMLPNP_EXPERIMENTS_CSV_HPP
#define GMLPNP_EXPERIMENTS_CSV_HPP

#include <sstream>
#include <string>
#include <vector>

#include "statistics.hpp"

namespace experiments {

/** A CSV file with a header. Nothing is written before save(): a run that was interrupted leaves no half of a file. */
class Csv
{
public:
    Csv(const std::string& folder, const std::string& name, const std::vector<std::string>& columns);

    Csv& operator<<(const std::string& cell);
    Csv& operator<<(double cell);  //!< not a number: an empty cell
    Csv& operator<<(int cell) { return *this << std::to_string(cell); }
    Csv& operator<<(const Interval& interval) { return *this << interval.value << interval.low << interval.high; }
    /** @throws std::logic_error where the row does not fit the header. */
    void endRow();
    /** @throws std::runtime_error where the file cannot be written. */
    void save() const;

private:
    const std::string path_;
    const size_t columns_;
    size_t cells_ = 0;
    std::ostringstream text_;
};

/** `name`, `name_low`, `name_high`. */
std::vector<std::string> intervalColumns(const std::string& name);

std::vector<std::string> operator+(std::vector<std::string> a, const std::vector<std::string>& b);

}  // namespace experiments

#endif  // GMLPNP_EXPERIMENTS_CSV_HPP
