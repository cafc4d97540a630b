// SPDX-License-Identifier: Apache-2.0
#ifndef JPRIM_SRC_MECHANISM_MECHANISM_VOCABULARY_H_
#define JPRIM_SRC_MECHANISM_MECHANISM_VOCABULARY_H_

#include <set>
#include <string>
#include <unordered_map>
#include <vector>

#include "jprim/dataset/dataset.h"
#include "jprim/expression/spline.h"
#include "jprim/mechanism/element.h"
#include "marker/marker_vocabulary.h"
#include "mechanism/control/control_plan.h"

namespace jprim {

class ControlVariables;

/// What the functions of a dataset can refer to besides markers. Elements are those that are built so far:
/// functions of constraints and forces may not refer to them anyway.
struct FunctionContext {
    UnitSystem units;
    ElementList elements;
    std::unordered_map<int, const VariableStatement*> variables;
    std::unordered_map<int, InterpolatingSpline> splines;
    std::set<int> floatingMarkers;
    ControlPlan control;
    const ControlVariables* controlVariables =
        nullptr;  ///< where a State has them; null if nothing is evaluated

    /// Lets functions mention the load of an element that has a mistake of its own.
    void addUnknownLoad(const ElementId& element);
};

/// What a function is for, which decides what it may depend on.
enum class FunctionUse { Output, Force, Equation, OfTime };

/// The measures of markers, VARVAL(id), and
/// - JPRIM, JOINT, GCON, MOTION, SFORCE, SPDP, BUSH, GFORCE, VFORCE, VTORQ(id, jflag, comp, rm): loads of
///   elements, which are known only once accelerations are
/// - FX FY FZ FM TX TY TZ TM(i, j, k): the sum of the loads on i from elements between i and j
/// - ORIENT(27, k, i, j): the k-th Euler parameter of i in j
/// - DIF, DIF1(id), ARYVAL, PINVAL, POUVAL(id, k), SENVAL(id): what control systems tell
class MechanismVocabulary final : public MarkerVocabulary {
public:
    MechanismVocabulary(MarkerFrames& frames, const MarkerFrames::FindMarker& find,
                        const FunctionContext& context, FunctionUse use)
        : MarkerVocabulary(frames), m_find(find), m_context(context), m_use(use) {}

    std::optional<Operand> call(ProgramBuilder& builder, const Call& call) override;
    const InterpolatingSpline* findSpline(int id) override;
    std::vector<std::string> getNames() const override;
    std::string findProblem(const ProgramBuilder& builder, Operand value) const override;

    /// The derivative of a state. @throws ExpressionError
    Operand makeRate(ProgramBuilder& builder, size_t k);
    /// What is zero for the derivative of an implicit state, which is the scalar input `unknown` of the program; -1 if it
    /// is none of it. @throws ExpressionError
    Operand makeEquation(ProgramBuilder& builder, size_t k, int& unknown);

protected:
    std::string describeMissing(int id) const override;
    const std::string* findVariable(int id) const override;

private:
    std::optional<Operand> makeMeasure(ProgramBuilder& builder, const Call& call);
    Operand makeElementLoad(const Call& call, ElementKind kind);
    Operand makeNetLoad(const Call& call, int component);
    Operand makeEulerParameter(const Call& call);
    Marker getMarker(int id) const { return id == 0 ? Marker() : *m_find(id); }

    static std::vector<std::string> getControlNames();
    [[noreturn]] static void throwMissing(const Call& call, const std::string& keyword, int id);
    /// The place of an element whose number is the second argument.
    static size_t requireElement(const Call& call, const std::string& keyword, int id, int number, int size);
    std::optional<Operand> callControl(ProgramBuilder& builder, const Call& call);
    void requireStates(size_t offset) const;
    Operand makeState(size_t k, size_t offset);
    Operand makeDerivative(ProgramBuilder& builder, size_t offset, size_t k);
    Operand makeImplicitDerivative(ProgramBuilder& builder, size_t offset, size_t k);
    /// The FUNCTION of a DIFF.
    Operand makeFunction(ProgramBuilder& builder, size_t offset, size_t k);
    Operand makeSensorValue(const Call& call, int id);
    Operand makePlantValue(ProgramBuilder& builder, const Call& call,
                           const std::map<int, const PlantStatement*>& plants, const std::string& keyword,
                           const std::vector<int>& ids);
    Operand makeArrayElement(ProgramBuilder& builder, const Call& call, int id, int number);
    Operand makeLinear(ProgramBuilder& builder, const LinearSystem& system, const Coefficients& ofStates,
                       const Coefficients& ofInputs, int row, size_t offset);

    const MarkerFrames::FindMarker& m_find;
    const FunctionContext& m_context;
    FunctionUse m_use;

    /// A DIFF whose equation is being compiled, and its derivative in there.
    struct Unknown {
        size_t state;
        int input = -1;
        Operand derivative;
    };
    std::vector<Unknown> m_unknowns;  // outermost first
};

}  // namespace jprim

#endif
