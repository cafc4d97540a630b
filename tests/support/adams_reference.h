// SPDX-License-Identifier: Apache-2.0
#ifndef JPRIM_TESTS_SUPPORT_ADAMS_REFERENCE_H_
#define JPRIM_TESTS_SUPPORT_ADAMS_REFERENCE_H_

#include <cmath>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

#include "support/run_dataset.h"

/// @file
/// Adams' results in tests/data/adams, and vectors of columns to compare with them.
namespace jprim::testing {

/// Rows of numbers under a header, '#' lines skipped.
inline Table readReference(const std::string& name) {
    std::ifstream file(getDataFolder() + "adams/" + name + ".csv");
    Table table;
    for (std::string line, word; std::getline(file, line);) {
        if (line.empty() || line[0] == '#') continue;
        std::istringstream words(line);
        while (std::getline(words, word, ','))
            if (std::isalpha(static_cast<unsigned char>(word[0])))
                table.columns.push_back(word);
            else
                table.values.push_back(std::stod(word));
    }
    if (table.getNumRows() == 0) throw std::runtime_error("no reference " + name);
    return table;
}

using Vectors = std::vector<SimTK::Vec3>;

inline Vectors getVectors(const Table& table, const std::vector<std::string>& names) {
    Vectors vectors(table.getNumRows());
    for (int k = 0; k < 3; ++k) {
        const std::vector<double> column = table.getColumn(names[k]);
        for (size_t row = 0; row < vectors.size(); ++row) vectors[row][k] = column[row];
    }
    return vectors;
}

/// The named vector, for example ("JOINT/1.I.F") -> its x, y and z columns; several are added.
inline Vectors sumVectors(const Table& table, const std::vector<std::string>& prefixes) {
    Vectors sum(table.getNumRows(), SimTK::Vec3(0));
    for (const std::string& prefix : prefixes) {
        const Vectors vectors = getVectors(table, {prefix + "X", prefix + "Y", prefix + "Z"});
        for (size_t row = 0; row < sum.size(); ++row) sum[row] += vectors[row];
    }
    return sum;
}

/// Root of the mean square over all rows and components.
inline double calcRms(const Vectors& a, const Vectors& b) {
    double sum = 0;
    for (size_t row = 0; row < a.size(); ++row) sum += (a[row] - b[row]).normSqr();
    return std::sqrt(sum / double(3 * a.size()));
}

inline double findPeak(const Vectors& v) {
    double peak = 0;
    for (const SimTK::Vec3& x : v) peak = std::max(peak, x.norm());
    return peak;
}

inline double findSize(const Vectors& path) {
    double size = 0;
    for (const SimTK::Vec3& x : path) size = std::max(size, (x - path.front()).norm());
    return size;
}

}  // namespace jprim::testing

#endif
