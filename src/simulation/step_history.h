// SPDX-License-Identifier: Apache-2.0
#ifndef JPRIM_SRC_SIMULATION_STEP_HISTORY_H_
#define JPRIM_SRC_SIMULATION_STEP_HISTORY_H_

#include <deque>

#include "SimTKcommon.h"

namespace jprim {

/// Where a mechanism has been: the continuous variables after its last steps.
class StepHistory {
public:
    void add(const SimTK::State& state) {
        if (m_moments.size() == Length) m_moments.pop_front();
        m_moments.push_back({state.getTime(), state.getY()});
    }

    /// Takes the State back to the last moment not after `time`, or if there is none to the first one kept.
    void goBack(SimTK::State& state, SimTK::Real time) const {
        if (m_moments.empty()) return;
        auto moment = m_moments.rbegin();
        while (moment->time > time && std::next(moment) != m_moments.rend()) ++moment;
        state.setTime(moment->time);
        state.setY(moment->y);
    }

private:
    static constexpr size_t Length = 100;  // steps shrink by halves and less
    struct Moment {
        SimTK::Real time;
        SimTK::Vector y;
    };
    std::deque<Moment> m_moments;
};

}  // namespace jprim

#endif
