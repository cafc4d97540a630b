// SPDX-License-Identifier: Apache-2.0
// Sizes are exact by definition (international yard and pound agreement of 1959, standard gravity
// 9.80665 m/s^2) unless a comment says otherwise.
#include "jprim/base/units.h"

#include <algorithm>
#include <cctype>

namespace jprim {
namespace {

constexpr double StandardGravity = 9.80665;
constexpr double Inch = 0.0254;
constexpr double Foot = 12 * Inch;
constexpr double Pound = 0.45359237;
constexpr double PoundForce = Pound * StandardGravity;
constexpr double Slug = PoundForce / Foot;  // 1 lbf accelerates it by 1 ft/s^2

bool startsWithIgnoringCase(std::string_view word, std::string_view prefix) {
    return prefix.size() <= word.size() &&
           std::equal(prefix.begin(), prefix.end(), word.begin(),
                      [](unsigned char a, unsigned char b) { return std::toupper(a) == std::toupper(b); });
}

}  // namespace

const std::vector<Unit>& getUnits(Quantity quantity) {
    static const std::vector<Unit> force = {{"CENTINEWTON", 1e-2},
                                            {"DYNE", 1e-5},
                                            {"KILOGRAM_FORCE", StandardGravity},
                                            {"KNEWTON", 1e3},
                                            {"KPOUND_FORCE", 1e3 * PoundForce},
                                            {"MEGANEWTON", 1e6},
                                            {"MICRONEWTON", 1e-6},
                                            {"MILLINEWTON", 1e-3},
                                            {"NANONEWTON", 1e-9},
                                            {"NEWTON", 1},
                                            {"OUNCE_FORCE", PoundForce / 16},
                                            {"POUND_FORCE", PoundForce},
                                            {"POUNDAL", Pound * Foot}};
    static const std::vector<Unit> mass = {{"GRAM", 1e-3},
                                           {"KILOGRAM", 1},
                                           {"KPOUND_MASS", 1e3 * Pound},
                                           {"MILLIGRAM", 1e-6},
                                           {"MICROGRAM", 1e-9},
                                           {"NANOGRAM", 1e-12},
                                           {"OUNCE_MASS", Pound / 16},
                                           {"POUND_MASS", Pound},
                                           {"SLINCH", 12 * Slug},
                                           {"SLUG", Slug},
                                           {"TONNE", 1e3},
                                           {"US_TON", 2000 * Pound}};
    static const std::vector<Unit> length = {
        {"ANGSTROM", 1e-10},        {"CENTIMETER", 1e-2},  {"FOOT", Foot},
        {"KILOMETER", 1e3},         {"INCH", Inch},        {"METER", 1},
        {"MICROINCH", 1e-6 * Inch}, {"MICROMETER", 1e-6},  {"MILE", 5280 * Foot},
        {"MILLIMETER", 1e-3},       {"MILS", 1e-3 * Inch}, {"NANOMETER", 1e-9},
        {"YARD", 3 * Foot}};
    static const std::vector<Unit> time = {{"DAY", 86400},         {"HOUR", 3600}, {"MICROSECOND", 1e-6},
                                           {"MILLISECONDS", 1e-3}, {"MINUTE", 60}, {"NANOSECOND", 1e-9},
                                           {"SECOND", 1}};
    switch (quantity) {
        case Quantity::Force: return force;
        case Quantity::Mass: return mass;
        case Quantity::Length: return length;
        case Quantity::Time: break;
    }
    return time;
}

const char* getUnitName(Dimension dimension) {
    return dimension == Dimension::Length ? "length units" : "rad";
}

std::optional<Unit> findUnit(Quantity quantity, std::string_view name) {
    std::optional<Unit> found;
    if (name.empty()) return found;
    for (const Unit& unit : getUnits(quantity)) {
        if (!startsWithIgnoringCase(unit.name, name)) continue;
        if (unit.name.size() == name.size()) return unit;
        if (found) return std::nullopt;
        found = unit;
    }
    return found;
}

std::optional<UnitSystem> findUnitSystem(std::string_view name) {
    struct Named {
        std::string_view name;
        UnitSystem system;
    };
    static const Named systems[] = {{"MKS", {1, 1, 1, 1}},
                                    {"CGS", {1e-5, 1e-3, 1e-2, 1}},
                                    {"FPS", {PoundForce, Pound, Foot, 1}},
                                    {"IPS", {PoundForce, Pound, Inch, 1}},
                                    {"NONE", {1, 1, 1, 1}}};
    for (const Named& entry : systems)
        if (entry.name.size() == name.size() && startsWithIgnoringCase(entry.name, name)) return entry.system;
    return std::nullopt;
}

}  // namespace jprim
