// SPDX-License-Identifier: Apache-2.0
#include "dataset/statements/body_fields.h"

#include "base/format.h"

namespace jprim {

using C = RigidCoordinates;
using Kind = ArgumentKind;

std::vector<Field<C>> poseFields() {
    return {field(ArgumentRule("QG", Kind::Real).of(3), &C::qg),
            field(ArgumentRule("REULER", Kind::Angle).of(3), &C::reuler),
            field(ArgumentRule("ZG", Kind::Real).of(3), &C::zg),
            field(ArgumentRule("XG", Kind::Real).of(3), &C::xg)};
}

std::vector<Field<C>> velocityFields() {
    return {field({"VX", Kind::Real, ExactOnly}, element(&C::v, 0)),
            field({"VY", Kind::Real, ExactOnly}, element(&C::v, 1)),
            field({"VZ", Kind::Real, ExactOnly}, element(&C::v, 2))};
}

std::vector<Field<C>> rotationFields() {
    return {field({"WX", Kind::Angle, ExactOnly}, element(&C::w, 0)),
            field({"WY", Kind::Angle, ExactOnly}, element(&C::w, 1)),
            field({"WZ", Kind::Angle, ExactOnly}, element(&C::w, 2)),
            field({"VM", Kind::Marker, ExactOnly}, &C::vm), field({"WM", Kind::Marker, ExactOnly}, &C::wm)};
}

namespace {

using Coordinates = SpellingTable<PartCoordinate>;

const Coordinates& getCoordinates(bool turns) {
    using P = PartCoordinate;
    static const Coordinates all = {{P::X, "X"},     {P::Y, "Y"},         {P::Z, "Z"},
                                    {P::Psi, "PSI"}, {P::Theta, "THETA"}, {P::Phi, "PHI"}};
    static const Coordinates ofPoint = {{P::X, "X"}, {P::Y, "Y"}, {P::Z, "Z"}};
    return turns ? all : ofPoint;
}

}  // namespace

Field<C> exactField(bool turns) {
    const Coordinates& coordinates = getCoordinates(turns);
    const auto isExact = [&coordinates](const C& c, std::size_t word) {
        return c.exact[static_cast<std::size_t>(coordinates.getValue(word))];
    };
    return {ArgumentRule("EXACT", Kind::Words).among(coordinates.getWords()),
            [&coordinates](C& c, const ArgumentValue& given) {
                for (const std::size_t word : given.words)
                    c.exact[static_cast<std::size_t>(coordinates.getValue(word))] = true;
            },
            [&coordinates, isExact](StatementWriter& writer, const C& c) {
                std::string words;
                for (std::size_t k = 0; k < coordinates.getWords().size(); ++k)
                    if (isExact(c, k))
                        words += (words.empty() ? "" : ":") + std::string(coordinates.getWords()[k].name);
                writer.add("EXACT", words);
            },
            [](const C& a, const C& b) { return a.exact == b.exact; }};
}

void checkMass(StatementReader& reader, const std::optional<double>& mass, int cm) {
    if (mass && *mass < 0)
        reader.addError(reader.getOffset("MASS"),
                        fmt::format("MASS of {} is {}; a mass cannot be negative", reader.getName(), *mass));
    if (mass && *mass > 0 && cm == 0)
        reader.addError(
            0, fmt::format("{} has a MASS but no mass centre; name its marker: CM=", reader.getName()));
}

void checkOrientation(StatementReader& reader, const char* z, const char* x) {
    reader.checkNotBoth("REULER", z);
    reader.checkNotBoth("REULER", x);
}

}  // namespace jprim
