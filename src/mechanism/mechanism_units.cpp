// SPDX-License-Identifier: Apache-2.0
#include "mechanism/mechanism_units.h"

#include <algorithm>
#include <cmath>

#include "base/format.h"

namespace jprim {
namespace {

// UCF is the force unit in units of mass * length / time^2. Given alone it is the only thing known of the
// units; given beside names it must agree with them.
void applyUcf(const UnitsStatement& statement, UnitSystem& units, Reporter& reporter) {
    if (!statement.ucf) return;
    const bool named = !statement.system.empty() || !statement.names[0].empty();
    const double consistent = units.force / (units.mass * units.getAcceleration());
    if (!named)
        units.force = *statement.ucf;
    else if (std::abs(*statement.ucf / consistent - 1) > 1e-3)
        reporter.addWarning(
            statement.where,
            fmt::format(
                "UCF={} does not fit the named units, whose factor is {:.6g}; the named units are used",
                *statement.ucf, consistent));
}

}  // namespace

UnitSystem findUnits(const Dataset& dataset, Reporter& reporter) {
    if (!dataset.units) return UnitSystem();
    UnitSystem units = dataset.units->toSI;
    applyUcf(*dataset.units, units, reporter);
    return units;
}

double chooseLengthUnit(const Dataset& dataset, const ModesOfBodies& modes, const GivenPoses& poses) {
    double largest = 0;
    for (std::size_t k = 0; k < dataset.parts.size(); ++k) {
        const PartStatement& part = dataset.parts[k];
        if (!part.ground && part.cm != 0)
            largest = std::max(largest, poses.calcReach(int(k), poses.getPoseOnPart(part.cm).p()));
    }
    for (const auto& [id, basis] : modes)
        for (const ModalNode& node : basis.nodes)
            largest = std::max(largest, (node.position - basis.rigid.center).norm());
    if (largest == 0 || !std::isfinite(largest)) return 1;
    return std::pow(1000., std::round(std::log10(largest) / 3));
}

UnitSystem convertUnits(const UnitSystem& toSI, double lengthUnit) {
    UnitSystem units = toSI;
    units.length /= lengthUnit;
    units.force /= lengthUnit;
    return units;
}

}  // namespace jprim
