// SPDX-License-Identifier: Apache-2.0
#include "jprim/mechanism/build_mechanism.h"

#include "base/sort_diagnostics.h"
#include "mechanism/bodies/bodies.h"
#include "mechanism/check_axes.h"
#include "mechanism/control/control_variables.h"
#include "mechanism/elements/coordinates.h"
#include "mechanism/elements/elements.h"
#include "mechanism/mechanism_units.h"
#include "mechanism/outputs.h"
#include "mechanism/power.h"

namespace jprim {

using SimTK::Vec3;

namespace {

void addGravity(const Dataset& dataset, MechanismContents& contents) {
    if (!dataset.gravity) return;
    const Triple& g = dataset.gravity->acceleration;
    contents.gravity = contents.units.getAcceleration() * Vec3(g[0], g[1], g[2]);
    SimTK::Force::Gravity(contents.forces, contents.matter, contents.gravity);
}

// On a node of a flexible body, which undeformed has the axes of the body; or fixed to the body's frame. (A node that is
// missing was reported with the marker's pose.)
Marker makeMarker(const MarkerStatement& statement, const MechanismPart& part, const GivenPoses& poses) {
    const SimTK::Transform X_BM = part.bcs.getPose() * poses.getPoseOnPart(statement.id);
    if (part.flexible)
        for (const ModalNode& node : part.flexible->getBasis().nodes)
            if (node.id == statement.node)
                return Marker(*part.flexible, statement.node, SimTK::Transform(-node.position) * X_BM);
    return Marker(part.body, X_BM);
}

void addMarkers(const Dataset& dataset, const GivenPoses& poses, MechanismContents& contents) {
    contents.markers[0] = Marker(contents.matter.updGround());
    for (const MarkerStatement& statement : dataset.markers)
        contents.markers[statement.id] =
            makeMarker(statement, contents.parts[size_t(poses.getPart(statement.id))], poses);
    size_t place = 0;
    const auto setAxes = [&](const auto& statements) {
        for (const RigidCoordinates& statement : statements) {
            MechanismPart& part = contents.parts[place++];
            if (part.ground) continue;
            part.vm = contents.markers.at(statement.vm);
            part.wm = statement.wm == 0 ? part.cm : contents.markers.at(statement.wm);
        }
    };
    setAxes(dataset.parts);
    setAxes(dataset.pointMasses);
    setAxes(dataset.flexBodies);
}

ElementId getId(const JprimStatement& s) {
    return {ElementKind::Jprim, s.id};
}
ElementId getId(const JointStatement& s) {
    return {ElementKind::Joint, s.id};
}
ElementId getId(const GconStatement& s) {
    return {ElementKind::Gcon, s.id};
}
ElementId getId(const MotionStatement& s) {
    return {ElementKind::Motion, s.id};
}
ElementId getId(const CouplerStatement& s) {
    return {ElementKind::Coupler, s.id};
}
ElementId getId(const SforceStatement& s) {
    return {ElementKind::Sforce, s.id};
}
ElementId getId(const VectorForceStatement& s) {
    return getElementId(s);
}
ElementId getId(const SpringdamperStatement& s) {
    return {ElementKind::Springdamper, s.id};
}
ElementId getId(const BushingStatement& s) {
    return {ElementKind::Bushing, s.id};
}

// Where a mistake is that no function is to blame for.
template <class Statement>
SourcePosition getPlace(const Statement& s) {
    return s.where;
}
SourcePosition getPlace(const GconStatement& s) {
    return s.function.getPosition(0);
}

// One with a mistake is put in the list all the same, without loads, so that what mentions it is not wrong on that account.
template <class Statements>
void addElements(const Statements& statements, const ElementContext& context, FunctionContext& functions,
                 Reporter& reporter) {
    for (const auto& s : statements) {
        const ElementId id = getId(s);
        const bool isMade = reporter.attempt(id.getText(), getPlace(s),
                                             [&] { functions.elements.add(makeElement(s, context)); });
        if (!isMade) functions.addUnknownLoad(id);
    }
}

void addElements(const ElementContext& context, FunctionContext& functions, Reporter& reporter) {
    const Dataset& d = context.dataset;
    addElements(d.jprims, context, functions, reporter);
    addElements(d.joints, context, functions, reporter);
    addElements(d.gcons, context, functions, reporter);
    addElements(d.motions, context, functions, reporter);
    addElements(d.couplers, context, functions, reporter);
    addElements(d.sforces, context, functions, reporter);
    addElements(d.vectorForces, context, functions, reporter);
    addElements(d.springdampers, context, functions, reporter);
    addElements(d.bushings, context, functions, reporter);
}

// The system holds the power, and the power a reference to the system.
void addWorkIntegral(MechanismContents& contents) {
    if (contents.isConservative()) return;
    Loads loads;
    loads.gravity = contents.gravity;
    for (const Element& element : contents.elements) {
        if (const MarkerForce* force = element.getForce())
            loads.forces.push_back(*force);
        else if (element.doesWork)
            loads.constraints.push_back(*element.getConstraint());
    }
    for (const MechanismPart& part : contents.parts)
        if (part.flexible) loads.flexibleBodies.push_back(*part.flexible);
    auto* work =
        new WorkIntegral(contents.forces, [&system = contents.system, loads](const SimTK::State& state) {
            return calcPowerWithoutPotential(system, loads, state);
        });
    SimTK::Force::Custom(contents.forces, work);  // takes it over
    contents.work = work;
}

std::unordered_map<int, const JointStatement*> indexJoints(const Dataset& dataset) {
    std::unordered_map<int, const JointStatement*> joints;
    for (const JointStatement& joint : dataset.joints) joints[joint.id] = &joint;
    return joints;
}

// Elements, and what looks at them.
void addElements(const Dataset& dataset, const TreePlan& plan, const GivenPoses& poses,
                 MechanismContents& contents, Reporter& reporter) {
    addMarkers(dataset, poses, contents);
    checkAxes(dataset, poses, reporter);
    const PlanarLoops planarLoops(plan, poses);
    FunctionContext functions = makeFunctionContext(dataset, contents.units, reporter);
    ControlVariables* const control = addControlVariables(functions.control, contents);
    contents.control = functions.controlVariables = control;
    const ElementContext context{dataset,   plan,     planarLoops,         poses,
                                 functions, contents, indexJoints(dataset)};
    addElements(context, functions, reporter);
    contents.initialCoordinates = makeInitialCoordinates(context);
    checkVariables(context, reporter);
    contents.states = makeStates(context, reporter);
    if (control) control->setStates(contents.states);
    contents.requests = makeRequests(context, reporter);
    contents.sensors = makeSensors(context, reporter);
    contents.elements = functions.elements;
    if (!reporter.hasErrors()) addWorkIntegral(contents);
}

std::optional<Mechanism> build(const Dataset& dataset, const BuildOptions& options, Reporter& reporter) {
    const TreePlan plan =
        options.formulation == Formulation::Tree ? planTree(dataset) : planFreeParts(dataset);
    const ModesOfBodies modes =
        loadModes(dataset, [&reporter](const SourcePosition& where, const std::string& message) {
            reporter.addError(where, message);
        });
    const UnitSystem toSI = findUnits(dataset, reporter);
    const GivenPoses inMetres(dataset, modes, toSI.length, reporter);

    auto contents = std::make_unique<MechanismContents>();
    contents->title = dataset.title;
    contents->lengthUnit = chooseLengthUnit(dataset, modes, inMetres);
    contents->units = convertUnits(toSI, contents->lengthUnit);
    const GivenPoses poses = inMetres.convertTo(contents->lengthUnit);
    addGravity(dataset, *contents);

    std::vector<NegativeMoment> negativeMoments;
    const BodyContext bodies{dataset,   plan,    poses, modes, findLightestMass(dataset, contents->units),
                             *contents, reporter};
    addParts(bodies, negativeMoments);
    addPointMasses(bodies);
    addFlexBodies(bodies);
    if (int(contents->parts.size()) < poses.getNumParts()) return std::nullopt;  // markers on nothing

    addElements(dataset, plan, poses, *contents, reporter);
    if (reporter.hasErrors()) return std::nullopt;
    if (options.formulation == Formulation::Tree)
        contents->makeWithFreeParts = [dataset] {
            Diagnostics known;  // what was found in it has been said
            return std::move(buildMechanism(dataset, known, {Formulation::Constraints}).value());
        };
    std::optional<Mechanism> mechanism(Mechanism(std::move(contents)));
    checkNegativeMoments(*mechanism, negativeMoments, reporter);
    if (reporter.hasErrors()) return std::nullopt;
    return mechanism;
}

}  // namespace

std::optional<Mechanism> buildMechanism(const Dataset& dataset, Diagnostics& diagnostics,
                                        const BuildOptions& options) {
    const size_t earlier = diagnostics.size();
    Reporter reporter(diagnostics);
    std::optional<Mechanism> mechanism = build(dataset, options, reporter);
    sortByPosition(earlier, diagnostics);
    return mechanism;
}

}  // namespace jprim
