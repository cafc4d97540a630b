// SPDX-License-Identifier: Apache-2.0
#include "jprim/analysis/constraint_equations.h"

#include <typeinfo>

#include "base/format.h"
#include "general/general_constraint_impl.h"
#include "marker/find_implementation.h"
#include "primitive/pair_constraint_impl.h"

namespace jprim {

using SimTK::Constraint;
using SimTK::ConstraintIndex;
using SimTK::MultiplierIndex;
using SimTK::SimbodyMatterSubsystem;
using SimTK::State;

namespace {

// A Custom constraint as its Implementation's class: Simbody's own derive from it too, and their
// isInstanceOf() says yes to any Custom.
std::string nameCustomType(const Constraint::Custom& constraint) {
    const OpenHandle<Constraint::Custom> handle(constraint);
    std::string type = SimTK::demangle(typeid(handle.getImplementation()).name());
    const std::string nested = "::Implementation", suffix = "Impl";
    const auto removeEnding = [&type](const std::string& ending) {
        if (type.size() > ending.size() && type.substr(type.size() - ending.size()) == ending)
            type.resize(type.size() - ending.size());
    };
    removeEnding(nested);
    removeEnding(suffix);
    const size_t scope = type.rfind("::");
    return scope == std::string::npos ? type : type.substr(scope + 2);
}

template <class Type>
bool isInstanceOf(const Constraint& constraint) {
    return Type::isInstanceOf(constraint);
}

struct TypeEntry {
    const char* name;
    bool (*matches)(const Constraint&);
};

const TypeEntry BuiltInTypes[] = {{"Rod", isInstanceOf<Constraint::Rod>},
                                  {"Ball", isInstanceOf<Constraint::Ball>},
                                  {"Weld", isInstanceOf<Constraint::Weld>},
                                  {"PointInPlane", isInstanceOf<Constraint::PointInPlane>},
                                  {"PointOnLine", isInstanceOf<Constraint::PointOnLine>},
                                  {"ConstantAngle", isInstanceOf<Constraint::ConstantAngle>},
                                  {"ConstantOrientation", isInstanceOf<Constraint::ConstantOrientation>},
                                  {"NoSlip1D", isInstanceOf<Constraint::NoSlip1D>},
                                  {"ConstantCoordinate", isInstanceOf<Constraint::ConstantCoordinate>},
                                  {"ConstantSpeed", isInstanceOf<Constraint::ConstantSpeed>},
                                  {"ConstantAcceleration", isInstanceOf<Constraint::ConstantAcceleration>},
                                  {"LineOnLineContact", isInstanceOf<Constraint::LineOnLineContact>},
                                  {"PointOnPlaneContact", isInstanceOf<Constraint::PointOnPlaneContact>},
                                  {"SphereOnPlaneContact", isInstanceOf<Constraint::SphereOnPlaneContact>},
                                  {"SphereOnSphereContact", isInstanceOf<Constraint::SphereOnSphereContact>}};

std::string nameType(const Constraint& constraint) {
    for (const TypeEntry& entry : BuiltInTypes)
        if (entry.matches(constraint)) return entry.name;
    if (Constraint::Custom::isInstanceOf(constraint))
        return nameCustomType(Constraint::Custom::downcast(constraint));
    return "Constraint";
}

std::vector<std::string> describeEquations(const PairConstraintImpl& pair) {
    std::vector<std::string> words;
    for (int k = 0; k < pair.getNumEquations(); ++k) words.push_back(pair.describeEquation(k));
    return words;
}

// The name the user gave, else the element's own, else that of the class.
ElementName findName(const Constraint& constraint, const ElementNames& names) {
    const ConstraintIndex index = constraint.getConstraintIndex();
    const auto given = names.find(index);
    if (given != names.end()) return given->second;
    if (const auto* pair = findImplementation<PairConstraintImpl>(constraint))
        return {pair->getDescription(), describeEquations(*pair)};
    if (const auto* general = findImplementation<GeneralConstraintImpl>(constraint))
        return {general->getDescription(), {"its equation"}, general->getDimension()};
    return {fmt::format("{} (constraint {})", nameType(constraint), int(index)), {}};
}

SimTK::Real findScale(const Constraint& constraint, const State& state, int number) {
    if (const auto* pair = findImplementation<PairConstraintImpl>(constraint))
        return pair->getPlacements(state).scales[size_t(number)];
    const auto* general = findImplementation<GeneralConstraintImpl>(constraint);
    return general ? general->getStateScale(state) : 1;
}

void appendEquations(const Constraint& constraint, const State& state, const ElementNames& names,
                     std::vector<ConstraintEquation>& equations) {
    int mp = 0, mv = 0, ma = 0;
    constraint.getNumConstraintEquationsInUse(state, mp, mv, ma);
    MultiplierIndex firstP, firstV, firstA;
    constraint.getIndexOfMultipliersInUse(state, firstP, firstV, firstA);
    const auto* pair = findImplementation<PairConstraintImpl>(constraint);
    const ElementName name = findName(constraint, names);
    int number = 0;
    const auto append = [&](int count, MultiplierIndex first, KinematicLevel level) {
        for (int k = 0; k < count; ++k, ++number) {
            const bool isNamed = number < int(name.equations.size());
            equations.push_back(
                {name.element, isNamed ? name.equations[number] : fmt::format("equation {}", number + 1),
                 level, constraint.getConstraintIndex(), number, int(first) + k,
                 pair ? pair->getDimension(number) : name.dimension, findScale(constraint, state, number)});
        }
    };
    append(mp, firstP, KinematicLevel::Position);
    append(mv, firstV, KinematicLevel::Velocity);
    append(ma, firstA, KinematicLevel::Acceleration);
}

}  // namespace

const char* getEquationKind(KinematicLevel level) {
    switch (level) {
        case KinematicLevel::Position: return "holonomic";
        case KinematicLevel::Velocity: return "nonholonomic";
        case KinematicLevel::Acceleration: break;
    }
    return "acceleration";
}

ElementNames nameElements(const std::vector<Joint>& joints) {
    ElementNames names;
    for (const Joint& joint : joints) {
        ElementName& name = names[joint.getConstraintIndex()] = findName(joint, {});
        if (joint.getGeneralConstraint()) name.equations = {"its own equation"};
    }
    return names;
}

std::vector<ConstraintEquation> findEquations(const SimbodyMatterSubsystem& matter, const State& state,
                                              const ElementNames& names) {
    std::vector<ConstraintEquation> equations;
    for (ConstraintIndex index(0); index < matter.getNumConstraints(); ++index) {
        const Constraint& constraint = matter.getConstraint(index);
        if (!constraint.isDisabled(state)) appendEquations(constraint, state, names, equations);
    }
    return equations;
}

}  // namespace jprim
