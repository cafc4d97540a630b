// SPDX-License-Identifier: Apache-2.0
// UNITS and ACCGRAV: statements that stand once.
#include "base/format.h"
#include "base/text.h"
#include "dataset/statements.h"

namespace jprim {
namespace {

constexpr std::array<const char*, 4> QuantityNames = {"FORCE", "MASS", "LENGTH", "TIME"};

// The words as given; they are understood when all are known.
struct UnitsArguments {
    std::array<ArgumentValue, 4> names;
    ArgumentValue system;
    std::optional<double> ucf;
};

const ArgumentTable<UnitsArguments>& getUnitsTable() {
    using U = UnitsArguments;
    using V = ArgumentValue;
    static const ArgumentTable<U> table = {
        {{"FORCE", ArgumentKind::Text}, [](U& u, const V& v) { u.names[0] = v; }},
        {{"MASS", ArgumentKind::Text}, [](U& u, const V& v) { u.names[1] = v; }},
        {{"LENGTH", ArgumentKind::Text}, [](U& u, const V& v) { u.names[2] = v; }},
        {{"TIME", ArgumentKind::Text}, [](U& u, const V& v) { u.names[3] = v; }},
        {{"SYSTEM", ArgumentKind::Text}, [](U& u, const V& v) { u.system = v; }},
        {{"UCF", ArgumentKind::Real, ExactOnly}, [](U& u, const V& v) { u.ucf = v.getNumber(); }}};
    return table;
}

void understandSystem(StatementReader& reader, const UnitsArguments& arguments, UnitsStatement& units) {
    const std::string& name = arguments.system.text;
    if (const auto system = findUnitSystem(name)) {
        for (const char c : name) units.system += toUpper(c);
        units.toSI = *system;
    } else {
        reader.addError(arguments.system.offset, fmt::format("SYSTEM of UNITS: {} is not one of MKS, CGS, "
                                                             "FPS, IPS, NONE",
                                                             quote(name)));
    }
}

void understandNames(StatementReader& reader, const UnitsArguments& arguments, UnitsStatement& units) {
    double* const factors[] = {&units.toSI.force, &units.toSI.mass, &units.toSI.length, &units.toSI.time};
    for (std::size_t i = 0; i < QuantityNames.size(); ++i) {
        const ArgumentValue& given = arguments.names[i];
        const auto unit = findUnit(static_cast<Quantity>(i), given.text);
        if (!reader.has(QuantityNames[i])) {
            reader.addError(0, fmt::format("UNITS needs {0}: {0}=", QuantityNames[i]));
        } else if (!unit) {
            reader.addError(given.offset, fmt::format("{} of UNITS: {} is unknown or ambiguous; write the "
                                                      "unit's name in full",
                                                      QuantityNames[i], quote(given.text)));
        } else {
            units.names[i] = std::string(unit->name);
            *factors[i] = unit->inSI;
        }
    }
}

// A second UNITS or ACCGRAV would silently win over the first.
template <class Statement>
bool checkOnce(StatementReader& reader, const std::optional<Statement>& earlier) {
    if (earlier)
        reader.addError(0, fmt::format("{} is already given in line {}; it may stand once",
                                       reader.getKeyword(), earlier->where.line));
    return !earlier;
}

}  // namespace

void readUnits(StatementReader& reader) {
    UnitsArguments arguments;
    std::optional<UnitsStatement>& target = reader.updState().dataset.units;
    if (!reader.readArguments(getUnitsTable(), arguments) || !checkOnce(reader, target)) return;
    UnitsStatement units;
    units.where = reader.getPosition();
    units.ucf = arguments.ucf;
    bool anyName = false;
    for (const char* name : QuantityNames) anyName = anyName || reader.has(name);
    if (units.ucf && *units.ucf <= 0)
        reader.addError(reader.getOffset("UCF"), "UCF of UNITS must be larger than 0");
    if (anyName && reader.has("SYSTEM"))
        reader.addError(reader.getOffset("SYSTEM"), "UNITS takes SYSTEM or the four units, not both");
    else if (reader.has("SYSTEM"))
        understandSystem(reader, arguments, units);
    else if (anyName || !units.ucf)
        understandNames(reader, arguments, units);
    if (!reader.hasErrors()) target = units;
}

void readAccgrav(StatementReader& reader) {
    using A = AccgravStatement;
    using V = ArgumentValue;
    static const ArgumentTable<A> table = {
        {{"IGRAV", ArgumentKind::Real}, [](A& a, const V& v) { a.acceleration[0] = v.getNumber(); }},
        {{"JGRAV", ArgumentKind::Real}, [](A& a, const V& v) { a.acceleration[1] = v.getNumber(); }},
        {{"KGRAV", ArgumentKind::Real}, [](A& a, const V& v) { a.acceleration[2] = v.getNumber(); }}};
    AccgravStatement gravity;
    gravity.where = reader.getPosition();
    std::optional<A>& target = reader.updState().dataset.gravity;
    if (reader.readArguments(table, gravity) && checkOnce(reader, target)) target = gravity;
}

}  // namespace jprim
