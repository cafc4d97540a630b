// SPDX-License-Identifier: Apache-2.0
#include "report/unit_names.h"

#include <algorithm>
#include <cctype>
#include <map>

#include "jprim/base/units.h"

namespace jprim {

namespace {

// Symbols of the International System and of English units; what has none keeps its name.
const std::map<std::string_view, const char*>& getSymbols() {
    static const std::map<std::string_view, const char*> symbols = {
        {"CENTINEWTON", "cN"},  {"DYNE", "dyn"},         {"KILOGRAM_FORCE", "kgf"},
        {"KNEWTON", "kN"},      {"KPOUND_FORCE", "kip"}, {"MEGANEWTON", "MN"},
        {"MICRONEWTON", "µN"},  {"MILLINEWTON", "mN"},   {"NANONEWTON", "nN"},
        {"NEWTON", "N"},        {"OUNCE_FORCE", "ozf"},  {"POUND_FORCE", "lbf"},
        {"POUNDAL", "pdl"},     {"GRAM", "g"},           {"KILOGRAM", "kg"},
        {"MILLIGRAM", "mg"},    {"MICROGRAM", "µg"},     {"NANOGRAM", "ng"},
        {"OUNCE_MASS", "oz"},   {"POUND_MASS", "lb"},    {"TONNE", "t"},
        {"CENTIMETER", "cm"},   {"FOOT", "ft"},          {"KILOMETER", "km"},
        {"INCH", "in"},         {"METER", "m"},          {"MICROINCH", "µin"},
        {"MICROMETER", "µm"},   {"MILE", "mi"},          {"MILLIMETER", "mm"},
        {"MILS", "mil"},        {"NANOMETER", "nm"},     {"YARD", "yd"},
        {"DAY", "d"},           {"HOUR", "h"},           {"MICROSECOND", "µs"},
        {"MILLISECONDS", "ms"}, {"MINUTE", "min"},       {"NANOSECOND", "ns"},
        {"SECOND", "s"}};
    return symbols;
}

std::string getSymbol(std::string_view name) {
    const auto found = getSymbols().find(name);
    if (found != getSymbols().end()) return found->second;
    std::string word(name);
    std::transform(word.begin(), word.end(), word.begin(), [](unsigned char c) { return std::tolower(c); });
    return word;
}

// By its name where the dataset has one, else by its size.
std::string findName(const UnitsStatement& units, std::size_t place, Quantity quantity, double inSI) {
    if (!units.names[place].empty()) return getSymbol(units.names[place]);
    for (const Unit& unit : getUnits(quantity))
        if (unit.inSI == inSI) return getSymbol(unit.name);
    return "";
}

}  // namespace

UnitNames findUnitNames(const Dataset& dataset) {
    const UnitsStatement units = dataset.units.value_or(UnitsStatement{});
    const UnitSystem& size = units.toSI;
    return {findName(units, 2, Quantity::Length, size.length),
            findName(units, 0, Quantity::Force, size.force), findName(units, 1, Quantity::Mass, size.mass),
            findName(units, 3, Quantity::Time, size.time)};
}

std::string UnitNames::getName(const std::string& dimension) const {
    const std::map<std::string_view, std::string> names = {{"time", time},
                                                           {"length", length},
                                                           {"length/time", length + "/" + time},
                                                           {"length/time^2", length + "/" + time + "²"},
                                                           {"rad", "rad"},
                                                           {"rad/time", "rad/" + time},
                                                           {"rad/time^2", "rad/" + time + "²"},
                                                           {"force", force},
                                                           {"force length", force + " " + length},
                                                           {"mass^(1/2) length", mass + "^½ " + length}};
    const auto found = names.find(dimension);
    return found == names.end() ? "" : found->second;
}

}  // namespace jprim
