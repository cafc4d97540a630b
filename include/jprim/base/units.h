// SPDX-License-Identifier: Apache-2.0
#ifndef JPRIM_BASE_UNITS_H_
#define JPRIM_BASE_UNITS_H_

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace jprim {

/// The four base quantities that an Adams dataset chooses units for. Angles are always radians.
enum class Quantity { Force, Mass, Length, Time };

/// What a coordinate or the error of an equation is: a length, or an angle [rad].
enum class Dimension { Length, Angle };

/// The unit of a dataset's value in a message: "length units" or "rad".
[[nodiscard]] const char* getUnitName(Dimension dimension);

/// A unit's Adams name and its size in SI: newton, kilogram, metre or second.
struct Unit {
    std::string_view name;
    double inSI = 1;
};

/// All units Adams knows for a quantity, by their full Adams names.
[[nodiscard]] const std::vector<Unit>& getUnits(Quantity quantity);

/// Factors from a dataset's units to SI (m, kg, s, N): `value_SI = factor * value`.
struct UnitSystem {
    double force = 1;
    double mass = 1;
    double length = 1;
    double time = 1;

    [[nodiscard]] double getDisplacement(Dimension dimension) const {
        return dimension == Dimension::Length ? length : 1;
    }
    [[nodiscard]] double getVelocity() const { return length / time; }
    [[nodiscard]] double getAcceleration() const { return length / (time * time); }
    [[nodiscard]] double getAngularVelocity() const { return 1 / time; }
    [[nodiscard]] double getAngularAcceleration() const { return 1 / (time * time); }
    [[nodiscard]] double getMoment() const { return force * length; }
    [[nodiscard]] double getEnergy() const { return force * length; }
    [[nodiscard]] double getInertia() const { return mass * length * length; }
};

/// The unit with this name or an unambiguous abbreviation of it (case does not matter).
/// Empty if there is none or if more than one begins so.
[[nodiscard]] std::optional<Unit> findUnit(Quantity quantity, std::string_view name);

/// The named system of UNITS/SYSTEM: MKS, CGS, FPS, IPS or NONE (all factors 1). Empty if unknown.
[[nodiscard]] std::optional<UnitSystem> findUnitSystem(std::string_view name);

}  // namespace jprim

#endif
