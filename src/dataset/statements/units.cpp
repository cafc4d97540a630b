// SPDX-License-Identifier: Apache-2.0
#include "base/format.h"
#include "base/text.h"
#include "dataset/statements/statements.h"

namespace jprim {
namespace {

using S = UnitsStatement;
using Kind = ArgumentKind;

constexpr std::array<const char*, 4> QuantityNames = {"FORCE", "MASS", "LENGTH", "TIME"};

// The words stand there as given until all are known.
const FieldTable<S>& getFields() {
    static const FieldTable<S> fields = {field({"FORCE", Kind::Text}, element(&S::names, 0)),
                                         field({"MASS", Kind::Text}, element(&S::names, 1)),
                                         field({"LENGTH", Kind::Text}, element(&S::names, 2)),
                                         field({"TIME", Kind::Text}, element(&S::names, 3)),
                                         field({"SYSTEM", Kind::Text}, &S::system),
                                         field({"UCF", Kind::Real, ExactOnly}, &S::ucf)};
    return fields;
}

void understandSystem(StatementReader& reader, S& units) {
    if (const auto system = findUnitSystem(units.system)) {
        units.system = toUpperCase(units.system);
        units.toSI = *system;
    } else {
        reader.addError(reader.getValueOffset("SYSTEM"),
                        fmt::format("SYSTEM of UNITS: {} is not one of MKS, CGS, "
                                    "FPS, IPS, NONE",
                                    quote(units.system)));
    }
}

void understandNames(StatementReader& reader, S& units) {
    double* const factors[] = {&units.toSI.force, &units.toSI.mass, &units.toSI.length, &units.toSI.time};
    for (std::size_t i = 0; i < QuantityNames.size(); ++i) {
        const auto unit = findUnit(static_cast<Quantity>(i), units.names[i]);
        reader.checkNeeded(QuantityNames[i], true);
        if (!reader.has(QuantityNames[i])) continue;
        if (unit) {
            units.names[i] = std::string(unit->name);
            *factors[i] = unit->inSI;
        } else {
            reader.addError(
                reader.getValueOffset(QuantityNames[i]),
                fmt::format("{} of UNITS: {} is unknown or ambiguous; write the unit's name in full",
                            QuantityNames[i], quote(units.names[i])));
        }
    }
}

void check(StatementReader& reader, S& units) {
    bool anyName = false;
    for (const char* name : QuantityNames) anyName = anyName || reader.has(name);
    if (units.ucf && *units.ucf <= 0)
        reader.addError(reader.getOffset("UCF"), "UCF of UNITS must be larger than 0");
    if (anyName && reader.has("SYSTEM"))
        reader.addError(reader.getOffset("SYSTEM"), "UNITS takes SYSTEM or the four units, not both");
    else if (reader.has("SYSTEM"))
        understandSystem(reader, units);
    else if (anyName || !units.ucf)
        understandNames(reader, units);
}

bool isSame(const UnitSystem& a, const UnitSystem& b) {
    return a.force == b.force && a.mass == b.mass && a.length == b.length && a.time == b.time;
}

}  // namespace

StatementKind describeUnits() {
    StatementKind kind = makeSingleKind("UNITS", 3, getFields(), &Dataset::units, check);
    kind.equal = [equal = kind.equal](const Dataset& a, const Dataset& b) {
        return equal(a, b) && (!a.units || isSame(a.units->toSI, b.units->toSI));
    };
    return kind;
}

}  // namespace jprim
