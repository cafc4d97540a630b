// SPDX-License-Identifier: Apache-2.0
#include <utility>

#include "base/format.h"
#include "tool/check_report.h"

namespace jprim::tool {

using SimTK::Real;

namespace {

/// Lines of a label and what follows it.
class TextWriter {
public:
    explicit TextWriter(const CheckReport& report)
        : m_report(report),
          m_units(report.model.mechanism->getUnits()),
          m_length(getLengthName(report.model.dataset)) {}

    void addCounts();
    void addTree();
    void addGruebler();
    void addFreedoms();
    void addRedundant();
    void addViolation(const char* when, const Violation& violation);
    void addMoved();
    void addConflicts();
    void addMissed();
    void addFlipped();

    const std::vector<std::string>& getLines() const { return m_lines; }

private:
    template <class Value>
    void addLine(const std::string& label, const Value& value) {
        m_lines.push_back(fmt::format("{:<24}{}", label, value));
    }
    std::string formatAmount(Real amount, Dimension dimension) const {
        return fmt::format("{:.3g} {}", amount / m_units.getDisplacement(dimension),
                           dimension == Dimension::Length ? m_length : getUnitName(dimension));
    }

    const CheckReport& m_report;
    const UnitSystem& m_units;
    std::string m_length;
    std::vector<std::string> m_lines;
};

// One line for each element: "JOINT/1 REVOLUTE: translation of I along Xj, rotation between Zi and Xj".
std::vector<std::string> formatByElement(const std::vector<ConstraintEquation>& equations,
                                         const std::vector<int>& some) {
    std::vector<std::string> lines;
    std::string element;
    for (const int k : some) {
        const ConstraintEquation& equation = equations[size_t(k)];
        if (!lines.empty() && equation.element == element)
            lines.back() += ", " + equation.words;
        else
            lines.push_back(equation.getText());
        element = equation.element;
    }
    return lines;
}

void TextWriter::addCounts() {
    const Dataset& d = m_report.model.dataset;
    addLine("statements", fmt::format("{} built, {} ignored by rule", d.counts.built, d.counts.ignored));
    addLine("parts", fmt::format("{} (ground included)", d.parts.size()));
    if (!d.flexBodies.empty()) addLine("flexible bodies", d.flexBodies.size());
    addLine("markers", d.markers.size());
    for (const auto& [kind, types] : m_report.elements) {
        int sum = 0;
        std::vector<std::string> parts;
        for (const auto& [type, count] : types) {
            sum += count;
            if (!type.empty()) parts.push_back(fmt::format("{} {}", count, type));
        }
        addLine(kind, parts.empty() ? std::to_string(sum) : fmt::format("{} ({})", sum, join(parts, ", ")));
    }
    addLine("requests", d.requests.size());
}

// "PART/3 on PART/2 by Pin: JOINT/2"
void TextWriter::addTree() {
    if (!m_report.tree) return;
    std::string label = "tree";
    for (const TreeReport::Branch& branch : m_report.tree->branches) {
        const std::string elements =
            branch.elements.empty() ? "" : fmt::format(": {}", join(branch.elements, ", "));
        addLine(std::exchange(label, ""),
                fmt::format("{} on {} by {}{}", branch.part, branch.parent, branch.mobilizer, elements));
    }
    label = "loops and other joints";
    for (const std::string& element : m_report.tree->equations) addLine(std::exchange(label, ""), element);
}

void TextWriter::addGruebler() {
    addLine("equations", m_report.constraints.numEquations);
    addLine("Gruebler count", m_report.constraints.getGrueblerCount());
}

void TextWriter::addFreedoms() {
    const ConstraintReport& c = m_report.constraints;
    addLine("degrees of freedom", c.getDegreesOfFreedom());
    addLine("redundant equations", c.getNumRedundant());
    addLine("rank decided between", fmt::format("{:.2g} and {:.2g}", c.smallestKept, c.largestDropped));
    if (c.isSingularPosition())
        addLine("singular position", fmt::format("degrees of freedom nearby: {}", c.freedomsNearby));
}

void TextWriter::addRedundant() {
    const ConstraintReport& c = m_report.constraints;
    for (const RedundantEquation& r : c.redundant) {
        const ConstraintEquation& equation = c.equations[size_t(r.equation)];
        const std::string level = equation.level == KinematicLevel::Position
                                      ? ""
                                      : fmt::format(" ({})", getEquationKind(equation.level));
        addLine(r.onlyHere ? "redundant only here" : "redundant", equation.getText() + level);
        std::string label = "    follows from";
        for (const std::string& line : formatByElement(c.equations, r.dependsOn))
            addLine(std::exchange(label, ""), line);
        if (r.dependsOn.empty()) addLine(label, "nothing: no motion changes it");
    }
}

void TextWriter::addViolation(const char* when, const Violation& v) {
    m_lines.push_back(fmt::format("constraint error {:<8}{:.3g} {}, {:.3g} rad{}", when,
                                  v.length / m_units.length, m_length, v.angle,
                                  v.element.empty() ? "" : fmt::format(" (at {})", v.element)));
}

void TextWriter::addMoved() {
    for (const MovedPart& part : m_report.assembled->moved)
        addLine("moved by assembly", fmt::format("{} by {:.3g} {} and {:.3g} rad", part.part,
                                                 part.distance / m_units.length, m_length, part.angle));
}

void TextWriter::addConflicts() {
    const ConflictReport& report = m_report.failure->conflicts;
    if (report.isAssembled()) return addMissed();
    for (const Conflict& conflict : report.conflicts) {
        addLine("conflict",
                fmt::format("{} equations cannot be met together; left are", conflict.equations.size()));
        for (size_t k = 0; k < conflict.equations.size(); ++k) {
            const ConstraintEquation& equation = report.equations[size_t(conflict.equations[k])];
            addLine("", equation.getText() + ": " + formatAmount(conflict.errors[k], equation.dimension));
        }
    }
}

void TextWriter::addMissed() {
    const std::vector<MissedCoordinate>& missed = m_report.failure->missed;
    if (missed.empty()) {
        addLine("no conflict", "of positions: the equations can be met near the given ones");
        return;
    }
    addLine("conflict", "given coordinates contradict the constraints or each other; missed are");
    for (const MissedCoordinate& m : missed)
        addLine("", fmt::format("{} {}: {}", m.element, m.coordinate, formatAmount(m.amount, m.dimension)));
}

void TextWriter::addFlipped() {
    for (const FlippedAxes& axes : m_report.failure->flipped)
        addLine("flipped", fmt::format("{}: the {} of I and J are {:.4g} degrees apart", axes.element,
                                       axes.axes, axes.angle * SimTK_RADIAN_TO_DEGREE));
}

}  // namespace

std::vector<std::string> formatText(const CheckReport& report) {
    TextWriter text(report);
    text.addCounts();
    text.addTree();
    text.addGruebler();
    if (report.assembled) {
        text.addFreedoms();
        text.addRedundant();
        text.addViolation("given", report.given);
        text.addViolation("after", report.assembled->after);
        text.addMoved();
    } else {
        text.addViolation("given", report.given);
        text.addViolation("least", report.failure->left);
        text.addConflicts();
        text.addFlipped();
    }
    return text.getLines();
}

}  // namespace jprim::tool
