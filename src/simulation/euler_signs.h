// SPDX-License-Identifier: Apache-2.0
#ifndef JPRIM_SRC_SIMULATION_EULER_SIGNS_H_
#define JPRIM_SRC_SIMULATION_EULER_SIGNS_H_

#include <string>
#include <vector>

namespace jprim {

/// Euler parameters e and -e are the same orientation. Gives those of each row the sign of the row before.
class EulerSigns {
public:
    /// @param columns  names, among them PART/2.E0 … PART/2.E3 in a row
    explicit EulerSigns(const std::vector<std::string>& columns = {}) {
        for (std::size_t k = 0; k < columns.size(); ++k)
            if (endsWithE0(columns[k])) m_sets.push_back({k, {}});
    }

    void makeContinuous(std::vector<double>& row) {
        for (Set& set : m_sets) {
            double* const e = row.data() + set.first;
            double cosine = 0;
            for (int k = 0; k < 4; ++k) cosine += e[k] * set.last[k];
            for (int k = 0; k < 4; ++k) set.last[k] = e[k] = cosine < 0 ? -e[k] : e[k];
        }
    }

private:
    struct Set {
        std::size_t first;
        double last[4];
    };

    static bool endsWithE0(const std::string& name) {
        return name.size() > 3 && name.compare(name.size() - 3, 3, ".E0") == 0;
    }

    std::vector<Set> m_sets;
};

}  // namespace jprim

#endif
