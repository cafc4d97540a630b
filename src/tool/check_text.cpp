// SPDX-License-Identifier: Apache-2.0
#include <utility>

#include "base/format.h"
#include "tool/check_report.h"

namespace jprim::tool {

using SimTK::Real;

namespace {

/// Lines of a label and what follows it.
class Printer {
public:
    explicit Printer(const CheckReport& report)
        : m_report(report),
          m_units(report.model.mechanism->getUnits()),
          m_length(getLengthName(report.model.dataset)) {}

    void printCounts() const;
    void printTree() const;
    void printGruebler() const;
    void printFreedoms() const;
    void printRedundant() const;
    void printViolation(const char* when, const Violation& violation) const;
    void printMoved() const;
    void printConflicts() const;
    void printMissed() const;
    void printFlipped() const;

private:
    template <class Value>
    static void printLine(const std::string& label, const Value& value) {
        fmt::print("{:<24}{}\n", label, value);
    }
    std::string formatAmount(Real amount, Dimension dimension) const {
        return fmt::format("{:.3g} {}", amount / m_units.getDisplacement(dimension),
                           dimension == Dimension::Length ? m_length : getUnitName(dimension));
    }

    const CheckReport& m_report;
    const UnitSystem& m_units;
    std::string m_length;
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

void Printer::printCounts() const {
    const Dataset& d = m_report.model.dataset;
    printLine("statements", fmt::format("{} built, {} ignored by rule", d.counts.built, d.counts.ignored));
    printLine("parts", fmt::format("{} (ground included)", d.parts.size()));
    if (!d.flexBodies.empty()) printLine("flexible bodies", d.flexBodies.size());
    printLine("markers", d.markers.size());
    for (const auto& [kind, types] : m_report.elements) {
        int sum = 0;
        std::vector<std::string> parts;
        for (const auto& [type, count] : types) {
            sum += count;
            if (!type.empty()) parts.push_back(fmt::format("{} {}", count, type));
        }
        printLine(kind, parts.empty() ? std::to_string(sum) : fmt::format("{} ({})", sum, join(parts, ", ")));
    }
    printLine("requests", d.requests.size());
}

// "PART/3 on PART/2 by Pin: JOINT/2"
void Printer::printTree() const {
    if (!m_report.tree) return;
    std::string label = "tree";
    for (const TreeReport::Branch& branch : m_report.tree->branches) {
        const std::string elements =
            branch.elements.empty() ? "" : fmt::format(": {}", join(branch.elements, ", "));
        printLine(std::exchange(label, ""),
                  fmt::format("{} on {} by {}{}", branch.part, branch.parent, branch.mobilizer, elements));
    }
    label = "loops and other joints";
    for (const std::string& element : m_report.tree->equations) printLine(std::exchange(label, ""), element);
}

void Printer::printGruebler() const {
    printLine("equations", m_report.constraints.numEquations);
    printLine("Gruebler count", m_report.constraints.getGrueblerCount());
}

void Printer::printFreedoms() const {
    const ConstraintReport& c = m_report.constraints;
    printLine("degrees of freedom", c.getDegreesOfFreedom());
    printLine("redundant equations", c.getNumRedundant());
    printLine("rank decided between", fmt::format("{:.2g} and {:.2g}", c.smallestKept, c.largestDropped));
    if (c.isSingularPosition())
        printLine("singular position", fmt::format("degrees of freedom nearby: {}", c.freedomsNearby));
}

void Printer::printRedundant() const {
    const ConstraintReport& c = m_report.constraints;
    for (const RedundantEquation& r : c.redundant) {
        const ConstraintEquation& equation = c.equations[size_t(r.equation)];
        const std::string level = equation.level == KinematicLevel::Position
                                      ? ""
                                      : fmt::format(" ({})", getEquationKind(equation.level));
        printLine(r.onlyHere ? "redundant only here" : "redundant", equation.getText() + level);
        std::string label = "    follows from";
        for (const std::string& line : formatByElement(c.equations, r.dependsOn))
            printLine(std::exchange(label, ""), line);
        if (r.dependsOn.empty()) printLine(label, "nothing: no motion changes it");
    }
}

void Printer::printViolation(const char* when, const Violation& v) const {
    fmt::print("constraint error {:<8}{:.3g} {}, {:.3g} rad{}\n", when, v.length / m_units.length, m_length,
               v.angle, v.element.empty() ? "" : fmt::format(" (at {})", v.element));
}

void Printer::printMoved() const {
    for (const MovedPart& part : m_report.assembled->moved)
        printLine("moved by assembly", fmt::format("{} by {:.3g} {} and {:.3g} rad", part.part,
                                                   part.distance / m_units.length, m_length, part.angle));
}

void Printer::printConflicts() const {
    const ConflictReport& report = m_report.failure->conflicts;
    if (report.isAssembled()) return printMissed();
    for (const Conflict& conflict : report.conflicts) {
        printLine("conflict",
                  fmt::format("{} equations cannot be met together; left are", conflict.equations.size()));
        for (size_t k = 0; k < conflict.equations.size(); ++k) {
            const ConstraintEquation& equation = report.equations[size_t(conflict.equations[k])];
            printLine("", equation.getText() + ": " + formatAmount(conflict.errors[k], equation.dimension));
        }
    }
}

void Printer::printMissed() const {
    const std::vector<MissedCoordinate>& missed = m_report.failure->missed;
    if (missed.empty()) {
        printLine("no conflict", "of positions: the equations can be met near the given ones");
        return;
    }
    printLine("conflict", "given coordinates contradict the constraints or each other; missed are");
    for (const MissedCoordinate& m : missed)
        printLine("", fmt::format("{} {}: {}", m.element, m.coordinate, formatAmount(m.amount, m.dimension)));
}

void Printer::printFlipped() const {
    for (const FlippedAxes& axes : m_report.failure->flipped)
        printLine("flipped", fmt::format("{}: the {} of I and J are {:.4g} degrees apart", axes.element,
                                         axes.axes, axes.angle * SimTK_RADIAN_TO_DEGREE));
}

}  // namespace

void printText(const CheckReport& report) {
    const Printer printer(report);
    printer.printCounts();
    printer.printTree();
    printer.printGruebler();
    if (report.assembled) {
        printer.printFreedoms();
        printer.printRedundant();
        printer.printViolation("given", report.given);
        printer.printViolation("after", report.assembled->after);
        printer.printMoved();
    } else {
        printer.printViolation("given", report.given);
        printer.printViolation("least", report.failure->left);
        printer.printConflicts();
        printer.printFlipped();
    }
}

}  // namespace jprim::tool
