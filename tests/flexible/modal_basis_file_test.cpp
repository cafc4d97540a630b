// SPDX-License-Identifier: Apache-2.0
// Files of modes whose checksum fits what they hold, and what they hold cannot be.
#include <gtest/gtest.h>

#include <functional>

#include "base/format.h"
#include "jprim/flexible/modal_basis.h"
#include "jprim/flexible/reduce_to_modes.h"
#include "support/expect_error.h"
#include "support/mesh_folder.h"
#include "support/steel_beam.h"

namespace jprim {
namespace {

// As docs/flexible.md says: the FNV-1a hash of all bytes before the word.
std::string sign(const std::string& body) {
    std::uint64_t hash = 14695981039346656037u;
    for (const unsigned char byte : body) hash = (hash ^ byte) * 1099511628211u;
    return body + fmt::format("checksum {:016x}\n", hash);
}

// The file of a beam with the nodes 1 to 4 and three modes, without its checksum.
std::string makeBody(const testing::MeshFolder& folder) {
    saveModalBasis(reduceToModes(makeFiniteElementModel(testing::makeSteelBeam(3)), {{{2}, 0, {}}}, 3),
                   folder.getPath("beam.modes"));
    const std::string text = folder.read("beam.modes");
    return text.substr(0, text.rfind("checksum "));
}

void replaceRestOfLine(std::string& text, const std::string& word, const std::string& rest) {
    const std::size_t at = text.find("\n" + word) + 1 + word.size();
    text.replace(at, text.find('\n', at) - at, rest);
}

void replaceFirstFrequency(std::string& text, const std::string& value) {
    const std::size_t at = text.find("frequencies\n") + 12;
    text.replace(at, text.find('\n', at) - at, value);
}

//------------------------------------------------------------------------------------------------ damage
struct Damage {
    const char* name;
    std::function<void(std::string&)> damage;
    const char* message;
};

std::ostream& operator<<(std::ostream& out, const Damage& d) {
    return out << d.name;
}

class DamagedModes : public ::testing::TestWithParam<Damage> {};

TEST_P(DamagedModes, AreRefusedThoughTheChecksumFits) {
    const testing::MeshFolder folder;
    std::string body = makeBody(folder);
    loadModalBasis(folder.write("beam.modes", sign(body)));  // sound before
    GetParam().damage(body);
    const std::string path = folder.write("beam.modes", sign(body));
    EXPECT_EQ(folder.shorten(testing::catchError([&] { loadModalBasis(path); })), GetParam().message);
}

auto setFrequency(const char* value) {
    return [=](std::string& text) { replaceFirstFrequency(text, value); };
}

auto setRest(const char* word, const char* rest) {
    return [=](std::string& text) { replaceRestOfLine(text, word, rest); };
}

INSTANTIATE_TEST_SUITE_P(
    Each, DamagedModes,
    ::testing::Values(
        Damage{"FrequencyNaN", setFrequency("nan"), "beam.modes:10: a finite number is expected, not 'nan'"},
        Damage{"FrequencyInfinite", setFrequency("inf"),
               "beam.modes:10: a finite number is expected, not 'inf'"},
        Damage{"FrequencyZero", setFrequency("0"), "beam.modes:10: a frequency is 0; it must be positive"},
        Damage{"FrequencyNegative", setFrequency("-5"),
               "beam.modes:10: a frequency is -5; it must be positive"},
        Damage{"FrequencyHuge", setFrequency("1e999"), "beam.modes:10: a number is expected, not '1e999'"},
        Damage{"MassZero", setRest("mass", " 0"), "beam.modes:6: a mass is 0; it must be positive"},
        Damage{"MassNegative", setRest("mass", " -1.5"), "beam.modes:6: a mass is -1.5; it must be positive"},
        Damage{"MassBeyondCalculation", setRest("mass", " 1e300"),
               "beam.modes:6: 1e300 is too large to calculate with"},
        Damage{"MassTooSmall", setRest("mass", " 1e-300"),
               "beam.modes:6: a mass is 1e-300, too small to calculate with"},
        Damage{"FrequencyBeyondCalculation", setFrequency("1e300"),
               "beam.modes:10: 1e300 is too large to calculate with"},
        Damage{"CenterFarAway", setRest("center", " 1e6 0 0"),
               "beam.modes: the mass centre is 1e+06 m away from all nodes of a body of 2 m"},
        Damage{"InterfaceTwice", setRest("interfaces", " 2 2 2"), "beam.modes: interface 2 is given twice"},
        Damage{"MassNaN", setRest("mass", " nan"), "beam.modes:6: a finite number is expected, not 'nan'"},
        Damage{"CenterNaN", setRest("center", " 0 nan 0"),
               "beam.modes:7: a finite number is expected, not 'nan'"},
        Damage{
            "InertiaTriangle", setRest("inertia", " 1 2 3.5 0 0 0"),
            "beam.modes:8: the inertia is impossible: its largest principal moment 3.5 exceeds the sum of the "
            "others, 2 and 1"},
        Damage{
            "InertiaTriangleOfPrincipalMoments", setRest("inertia", " 2 2 1 1.5 0 0"),
            "beam.modes:8: the inertia is impossible: its largest principal moment 3.5 exceeds the sum of the "
            "others, 1 and 0.5"},
        Damage{"InertiaNegative", setRest("inertia", " -1 2 2 0 0 0"),
               "beam.modes:8: the inertia has the principal moments -1, 2, 2; they must be positive"},
        Damage{"InertiaIndefinite", setRest("inertia", " 1 1 1 0 0 2"),
               "beam.modes:8: the inertia has the principal moments -1, 1, 3; they must be positive"},
        Damage{"InertiaZero", setRest("inertia", " 0 0 0 0 0 0"),
               "beam.modes:8: the inertia has the principal moments 0, 0, 0; they must be positive"},
        Damage{"ModesNegative", setRest("modes", " -3"), "beam.modes:3: -3 is no number of things"},
        Damage{"MoreModes", setRest("modes", " 4"),
               "beam.modes:13: a number is expected, not 'inertia_change'"},
        Damage{"ManyModes", setRest("modes", " 2000000000"),
               "beam.modes:13: a number is expected, not 'inertia_change'"},
        Damage{"FewerModes", setRest("modes", " 2"),
               "beam.modes:12: 'inertia_change' is expected, not "
               "'743.6175655582115'"},
        Damage{"InterfaceUnknown", setRest("interfaces", " 1 9"),
               "beam.modes: interface 9 is none of the nodes"},
        Damage{"NodeTwice",
               [](std::string& text) {
                   const std::size_t at = text.find("node 3 ");
                   text[at + 5] = '2';
               },
               "beam.modes: node 2 is given twice"}),
    [](const auto& info) { return std::string(info.param.name); });

//------------------------------------------------------------------------------------------------ copies
std::string endLinesWithCrLf(const std::string& text) {
    std::string result;
    for (const char c : text) result += c == '\n' ? std::string("\r\n") : std::string(1, c);
    return result;
}

TEST(ModalBasisFile, ACopyWithOtherLineEndsIsTheSame) {
    const testing::MeshFolder folder;
    const std::string body = makeBody(folder);
    const ModalBasis basis = loadModalBasis(folder.getPath("beam.modes"));
    const ModalBasis copy = loadModalBasis(folder.write("copy.modes", endLinesWithCrLf(sign(body))));
    EXPECT_EQ(copy.frequencies, basis.frequencies);
    EXPECT_EQ(copy.name, "beam");
    std::string changed = endLinesWithCrLf(sign(body));
    changed[20] = changed[20] == '1' ? '2' : '1';
    const std::string path = folder.write("copy.modes", changed);
    EXPECT_EQ(
        folder.shorten(testing::catchError([&] { loadModalBasis(path); })),
        "copy.modes: has been changed since it was written (its checksum does not fit); copy it again or make "
        "it again with `jprim reduce`");
}

TEST(ModalBasisFile, ACopyWithAMarkAndWithoutItsLastLineEndIsTheSame) {
    const testing::MeshFolder folder;
    std::string text = sign(makeBody(folder));
    text.pop_back();
    const ModalBasis copy = loadModalBasis(folder.write("copy.modes", "\xEF\xBB\xBF" + text));
    EXPECT_EQ(copy.frequencies, loadModalBasis(folder.getPath("beam.modes")).frequencies);
}

TEST(ModalBasisFile, SaysWhatIsTooMuch) {
    const testing::MeshFolder folder;
    const std::string text = sign(makeBody(folder));
    for (const auto& [tail, size] :
         {std::pair("\n", "1 byte"), {"x", "1 byte"}, {"\r\n", "1 byte"}, {"checksum\n", "9 bytes"}})
        EXPECT_EQ(
            folder.shorten(testing::catchError(
                [&, tail = tail] { loadModalBasis(folder.write("beam.modes", text + tail)); })),
            fmt::format("beam.modes: goes on after its last line, the checksum, for {}; delete what is too "
                        "much",
                        size));
}

}  // namespace
}  // namespace jprim
