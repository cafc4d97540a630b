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

namespace jprim {

/// What the functions of a dataset can refer to besides markers. Elements are those that are built so far:
/// functions of constraints and forces may not refer to them anyway.
struct FunctionContext {
    UnitSystem units;
    ElementList elements;
    std::unordered_map<int, const VariableStatement*> variables;
    std::unordered_map<int, InterpolatingSpline> splines;
    std::set<int> floatingMarkers;

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
class MechanismVocabulary final : public MarkerVocabulary {
public:
    MechanismVocabulary(MarkerFrames& frames, const MarkerFrames::FindMarker& find,
                        const FunctionContext& context, FunctionUse use)
        : MarkerVocabulary(frames), m_find(find), m_context(context), m_use(use) {}

    std::optional<Operand> call(ProgramBuilder& builder, const Call& call) override;
    const InterpolatingSpline* findSpline(int id) override;
    std::vector<std::string> getNames() const override;
    std::string findProblem(const ProgramBuilder& builder, Operand value) const override;

protected:
    std::string describeMissing(int id) const override;
    const std::string* findVariable(int id) const override;

private:
    std::optional<Operand> makeMeasure(ProgramBuilder& builder, const Call& call);
    Operand makeElementLoad(const Call& call, ElementKind kind);
    Operand makeNetLoad(const Call& call, int component);
    Operand makeEulerParameter(const Call& call);
    Marker getMarker(int id) const { return id == 0 ? Marker() : *m_find(id); }

    const MarkerFrames::FindMarker& m_find;
    const FunctionContext& m_context;
    FunctionUse m_use;
};

}  // namespace jprim

#endif
