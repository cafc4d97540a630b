// SPDX-License-Identifier: Apache-2.0
#include "simulation/output_times.h"

#include <cmath>

#include "base/format.h"
#include "jprim/base/error.h"

namespace jprim {
namespace {

// Decimal fractions rarely divide each other to the last digit.
bool isWhole(double number) {
    constexpr double Rounding = 1e-9;
    return number > 0.5 && std::abs(number - std::round(number)) <= Rounding * number;
}

}  // namespace

OutputTimes::OutputTimes(const SimulationOptions& options, double start)
    : m_start(start), m_end(options.end), m_numSteps(options.steps) {
    if (options.steps > MostOutputSteps)
        throw Error("steps",
                    fmt::format("{} are too many; at most {} can be", options.steps, MostOutputSteps));
    if (options.steps == 0 || !options.outputStep) return;
    const double step = *options.outputStep;
    if (!(step > 0) || !std::isfinite(step))
        throw Error("output step", fmt::format("{} is not a positive time", step));
    const double quotient = (m_end - start) / step;
    const double count = isWhole(quotient) ? std::round(quotient) : std::floor(quotient) + 1;
    if (count > MostOutputSteps)
        throw Error(
            "output step",
            fmt::format(
                "{} is too short for a run from {} to {}: there would be {:.0f} rows; at most {} can be",
                step, start, m_end, count + 1, MostOutputSteps));
    m_step = isWhole(quotient) ? 0 : step;
    m_numSteps = int(count);
}

double OutputTimes::getTime(int step) const {
    if (step == 0) return m_start;
    if (step == m_numSteps) return m_end;
    return m_step > 0 ? m_start + step * m_step : m_start + (m_end - m_start) * (double(step) / m_numSteps);
}

}  // namespace jprim
