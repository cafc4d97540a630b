// SPDX-License-Identifier: Apache-2.0
#include "jprim/dataset/write_dataset.h"

#include <algorithm>
#include <array>
#include <optional>
#include <string_view>

#include "base/format.h"
#include "dataset/statement_lexer.h"
#include "dataset/statement_writer.h"

namespace jprim {
namespace {

void write(StatementWriter& w, const UnitsStatement& u) {
    w.begin("UNITS", 0);
    w.add("FORCE", u.names[0]);
    w.add("MASS", u.names[1]);
    w.add("LENGTH", u.names[2]);
    w.add("TIME", u.names[3]);
    w.add("SYSTEM", u.system);
    w.add("UCF", u.ucf);
    w.end();
}

void write(StatementWriter& w, const AccgravStatement& a) {
    w.begin("ACCGRAV", 0);
    w.add("IGRAV", std::optional<double>(a.acceleration[0]));
    w.add("JGRAV", std::optional<double>(a.acceleration[1]));
    w.add("KGRAV", std::optional<double>(a.acceleration[2]));
    w.end();
}

void writeInertia(StatementWriter& w, const std::array<double, 6>& ip) {
    w.add("IP", Triple{ip[0], ip[1], ip[2]});
    if (ip[3] != 0 || ip[4] != 0 || ip[5] != 0) w.add(fmt::format("{}, {}, {}", ip[3], ip[4], ip[5]));
}

void writePose(StatementWriter& w, const RigidCoordinates& c) {
    w.add("QG", c.qg);
    w.add("REULER", c.reuler);
    w.add("ZG", c.zg);
    w.add("XG", c.xg);
}

void writeExact(StatementWriter& w, const std::array<bool, 6>& exact) {
    constexpr std::array<const char*, 6> names = {"X", "Y", "Z", "PSI", "THETA", "PHI"};
    std::string words;
    for (std::size_t i = 0; i < names.size(); ++i)
        if (exact[i]) words += (words.empty() ? "" : ":") + std::string(names[i]);
    w.add("EXACT", words);
}

void writeMotion(StatementWriter& w, const RigidCoordinates& c) {
    constexpr std::array<const char*, 3> linear = {"VX", "VY", "VZ"};
    constexpr std::array<const char*, 3> angular = {"WX", "WY", "WZ"};
    for (std::size_t i = 0; i < 3; ++i) w.add(linear[i], c.v[i]);
    for (std::size_t i = 0; i < 3; ++i) w.add(angular[i], c.w[i]);
    w.add("VM", c.vm);
    w.add("WM", c.wm);
    writeExact(w, c.exact);
}

void write(StatementWriter& w, const PartStatement& p) {
    w.begin("PART", p.id);
    if (p.ground) w.add("GROUND");
    writePose(w, p);
    w.add("MASS", p.mass);
    w.add("CM", p.cm);
    w.add("IM", p.im);
    if (p.ip) writeInertia(w, *p.ip);
    writeMotion(w, p);
    w.end();
}

// A name with marks that mean something elsewhere stands in quotes of the kind that it does not contain.
std::string quoteName(const std::string& name) {
    if (name.find_first_of(" \t\r\v\f'\",;&!") == name.npos) return name;
    const char mark = name.find('"') == name.npos ? '"' : '\'';
    return mark + name + mark;
}

void write(StatementWriter& w, const FlexBodyStatement& f) {
    w.begin("FLEX_BODY", f.id);
    w.add("MODES_FILE", quoteName(f.modesFile));
    writePose(w, f);
    writeMotion(w, f);
    if (f.constantCoupling) w.add("INVARIANTS=T:T:F:F:F:T:T:F:F");
    if (f.cratio) w.addExpression("CRATIO", fmt::format("{}", *f.cratio));
    w.end();
}

void write(StatementWriter& w, const PointMassStatement& p) {
    w.begin("POINT_MASS", p.id);
    writePose(w, p);
    w.add("MASS", p.mass);
    w.add("CM", p.cm);
    writeMotion(w, p);
    w.end();
}

void write(StatementWriter& w, const MarkerStatement& m) {
    w.begin("MARKER", m.id);
    w.add("PART", m.part);
    w.add("POINT_MASS", m.pointMass);
    w.add("FLEX_BODY", m.flexBody);
    w.add("NODE_ID", m.node);
    w.add("QP", m.qp);
    w.add("REULER", m.reuler);
    w.add("ZP", m.zp);
    w.add("XP", m.xp);
    if (m.usexp) w.add("USEXP");
    if (m.floating) w.add("FLOATING");
    w.end();
}

void write(StatementWriter& w, const RequestStatement& r) {
    w.begin("REQUEST", r.id);
    if (r.type != RequestType::Expressions) w.add(getAdamsName(r.type));
    w.add("I", r.i);
    w.add("J", r.j);
    w.add("RM", r.rm);
    w.add("COMMENT", r.comment);
    w.add("TITLE", r.title);
    w.add("CUNITS", r.cunits);
    w.add("CNAMES", r.cnames);
    w.add("CLABELS", r.clabels);
    w.add("CTITLE", r.ctitle);
    if (!r.resultsName.empty()) w.add("RESULTS_NAME", std::vector<std::string>{r.resultsName});
    for (const auto& [number, expression] : r.expressions)
        w.add(fmt::format("F{}", number), std::optional<ExpressionText>(expression));
    w.end();
}

// The text is a list of items, each followed by ", "; it may be broken between them.
void write(StatementWriter& w, const IgnoredStatement& s) {
    w.begin(s.keyword, s.id);
    std::string_view rest = s.arguments;
    while (!rest.empty()) {
        const std::size_t end = findItemEnd(rest, 0);
        w.add(rest.substr(0, end));
        rest.remove_prefix(std::min(end + 2, rest.size()));
    }
    w.end();
}

}  // namespace

std::string writeDataset(const Dataset& dataset) {
    std::string text = dataset.title + "\n";
    StatementWriter writer(text);
    const auto writeAll = [&](const auto& statements) {
        for (const auto& statement : statements) write(writer, statement);
    };
    if (dataset.units) write(writer, *dataset.units);
    writeAll(dataset.parts);
    writeAll(dataset.pointMasses);
    writeAll(dataset.flexBodies);
    writeAll(dataset.markers);
    writeAll(dataset.jprims);
    writeAll(dataset.joints);
    writeAll(dataset.gcons);
    writeAll(dataset.motions);
    writeAll(dataset.couplers);
    writeAll(dataset.sforces);
    writeAll(dataset.vectorForces);
    writeAll(dataset.springdampers);
    writeAll(dataset.bushings);
    writeAll(dataset.variables);
    writeAll(dataset.splines);
    writeAll(dataset.sensors);
    if (dataset.gravity) write(writer, *dataset.gravity);
    writeAll(dataset.requests);
    writeAll(dataset.ignored);
    return text + "END\n";
}

}  // namespace jprim
