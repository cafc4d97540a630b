// SPDX-License-Identifier: Apache-2.0
// Sound meshes damaged at random: whatever is wrong is refused by a message that names one of the files, and no
// wrong term of a matrix passes.
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "base/format.h"
#include "jprim/base/error.h"
#include "jprim/flexible/read_mesh.h"
#include "jprim/flexible/reduce_to_modes.h"
#include "support/mesh_folder.h"

namespace jprim {
namespace {

using Random = std::mt19937;

int pick(Random& random, std::size_t count) {
    return std::uniform_int_distribution<int>(0, int(count) - 1)(random);
}

template <class T>
const T& pickFrom(Random& random, const std::vector<T>& items) {
    return items[std::size_t(pick(random, items.size()))];
}

std::vector<std::string> splitLines(const std::string& text) {
    std::vector<std::string> lines;
    std::istringstream stream(text);
    for (std::string line; std::getline(stream, line);) lines.push_back(line);
    return lines;
}

std::string join(const std::vector<std::string>& lines) {
    std::string text;
    for (const std::string& line : lines) text += line + "\n";
    return text;
}

// One of the fields of a line, with what separates it.
struct Field {
    std::size_t begin, end;
};

std::vector<Field> findFields(const std::string& line) {
    std::vector<Field> fields;
    for (std::size_t at = 0; (at = line.find_first_not_of(" ,.=*", at)) != line.npos;) {
        const std::size_t end = std::min(line.find_first_of(" ,=", at), line.size());
        fields.push_back({at, end});
        at = end;
    }
    return fields;
}

//--------------------------------------------------------------------------------------------- damages
void replaceField(Random& random, std::string& line) {
    static const std::vector<std::string> texts = {
        "",      "nan",        "inf",         "-1",       "0",   "1.5",    "1e400",       "-1e300",
        "1e300", "2147483647", "x y z",       "\xc3\xa9", "- 5", "1e-320", "-2147483648", "99999999999",
        "ENDS",  "LEFT",       "*NODE, NSET", "7"};
    const std::vector<Field> fields = findFields(line);
    if (fields.empty()) return;
    const Field& field = pickFrom(random, fields);
    line.replace(field.begin, field.end - field.begin, pickFrom(random, texts));
}

void damageLines(Random& random, std::vector<std::string>& lines) {
    const auto at = lines.begin() + pick(random, lines.size());
    const auto other = lines.begin() + pick(random, lines.size());
    switch (pick(random, 7)) {
        case 0: lines.erase(at); break;
        case 1: lines.insert(other, std::string(*at)); break;
        case 2: std::iter_swap(at, other); break;
        case 3: at->insert(std::min(at->find_first_not_of(" *"), at->size()), "-"); break;
        case 4: *at += *other; break;
        case 5: lines.erase(std::min(at, other), std::max(at, other)); break;
        default: replaceField(random, *at);
    }
}

void damageBytes(Random& random, std::string& text) {
    const std::size_t at = std::size_t(pick(random, text.size()));
    switch (pick(random, 4)) {
        case 0: text.resize(at); break;
        case 1: text[at] = char(pick(random, 256)); break;
        case 2: text.insert(at, 1, char(pick(random, 256))); break;
        default: text.erase(at, std::size_t(pick(random, 40)));
    }
}

void damageFile(Random& random, const testing::MeshFolder& folder, const std::string& name) {
    std::string text = folder.read(name);
    if (pick(random, 20) == 0) {
        std::filesystem::remove(folder.getPath(name));
        if (pick(random, 2) == 0) std::filesystem::create_directory(folder.getPath(name));
        return;
    }
    if (pick(random, 3) == 0) {
        damageBytes(random, text);
    } else {
        std::vector<std::string> lines = splitLines(text);
        damageLines(random, lines);
        text = join(lines);
    }
    folder.write(name, text);
}

//---------------------------------------------------------------------------------------------- outcomes
// The message of the error, or empty if the mesh has been reduced.
std::string reduce(const testing::MeshFolder& folder, bool isHeld) {
    try {
        const FiniteElementMesh mesh = readCalculixMesh(folder.getPath("block.inp"));
        std::vector<InterfacePoint> points;
        if (isHeld) points.push_back({mesh.getNodeSet("LEFT"), 0, std::nullopt, "LEFT"});
        const ModalBasis basis = reduceToModes(mesh, points, 4);
        for (const double frequency : basis.frequencies)
            EXPECT_TRUE(frequency > 0 && std::isfinite(frequency));
    } catch (const Error& error) {
        EXPECT_NE(std::string(error.what()), "");
        return folder.shorten(error.what());
    }
    return "";
}

TEST(DamagedMeshes, AreRefusedByAMessageThatNamesAFile) {
    Random random(20261);
    int refused = 0;
    for (int round = 0; round < 600; ++round) {
        const testing::MeshFolder folder;
        folder.copyMesh("block");
        const std::string name =
            std::string("block.") + pickFrom<std::string>(random, {"inp", "dof", "sti", "mas"});
        damageFile(random, folder, name);
        const std::string message = reduce(folder, round % 2 == 0);
        if (message.empty()) continue;
        ++refused;
        EXPECT_EQ(message.rfind("block.", 0), 0u) << round << ": " << message;
        EXPECT_EQ(message.find('\n'), message.npos) << round << ": " << message;
    }
    EXPECT_GT(refused, 200);  // the damage is felt
}

//------------------------------------------------------------------------------------- a wrong term alone
// A term of one triangle of the block's matrices, by its line.
void expectRefusedTerm(const char* file, double factor, std::size_t line) {
    const testing::MeshFolder folder;
    folder.copyMesh("block");
    std::vector<std::string> lines = splitLines(folder.read(file));
    int row = 0, column = 0;
    double value = 0;
    std::istringstream(lines[line]) >> row >> column >> value;
    if (std::abs(value) < 1) return;  // the rounding of a zero
    lines[line] = fmt::format("{} {} {:.13e}", row, column, factor * value);
    folder.write(file, join(lines));
    const std::string message = reduce(folder, false);
    EXPECT_EQ(message.rfind(file, 0), 0u) << lines[line] << ": " << message;
    const bool isNamed = message.find(fmt::format("row {} ", row)) != message.npos ||
                         message.find(fmt::format("row {},", row)) != message.npos ||
                         message.find(fmt::format("row {} ", column)) != message.npos ||
                         message.find(fmt::format("row {},", column)) != message.npos;
    EXPECT_TRUE(isNamed) << lines[line] << ": " << message;
}

TEST(DamagedMeshes, NoWrongTermPassesAndItsRowIsNamed) {
    Random random(20262);
    for (const char* file : {"block.sti", "block.mas"})
        for (const double factor : {-1., 0., 0.999, 1.01, 1000.})
            for (int round = 0; round < 20; ++round)
                expectRefusedTerm(file, factor, std::size_t(pick(random, 522)));
}

}  // namespace
}  // namespace jprim
