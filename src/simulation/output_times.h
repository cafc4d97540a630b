// SPDX-License-Identifier: Apache-2.0
#ifndef JPRIM_SRC_SIMULATION_OUTPUT_TIMES_H_
#define JPRIM_SRC_SIMULATION_OUTPUT_TIMES_H_

#include "jprim/simulation/simulate.h"

namespace jprim {

/// When a simulation records, in the dataset's unit of time: at its start and its end, and in between at equal
/// steps, or at multiples of the output step counted from the start.
class OutputTimes {
public:
    /// @throws Error if the output step is not a positive time, or there are more than MostOutputSteps
    OutputTimes(const SimulationOptions& options, double start);

    int getNumSteps() const { return m_numSteps; }
    /// The time at the end of a step, from 1 to getNumSteps(); that of step 0 is the start.
    double getTime(int step) const;

private:
    double m_start = 0;
    double m_end = 0;
    double m_step = 0;  // 0 for equal steps
    int m_numSteps = 0;
};

}  // namespace jprim

#endif
