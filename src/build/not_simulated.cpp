// SPDX-License-Identifier: Apache-2.0
#include "build/not_simulated.h"

#include <fmt/format.h>

namespace jprim {
namespace {

class Check {
public:
    explicit Check(Diagnostics& diagnostics) : m_diagnostics(diagnostics) {}

    template <class Statement>
    void refuse(const char* keyword, const Statement& statement) {
        m_good = false;
        m_diagnostics.push_back(
            {Severity::Error, statement.where,
             fmt::format("{}/{} is read, but cannot be simulated yet", keyword, statement.id)});
    }
    template <class Statement>
    void refuseAll(const char* keyword, const std::vector<Statement>& statements) {
        for (const Statement& statement : statements) refuse(keyword, statement);
    }
    bool isGood() const { return m_good; }

private:
    Diagnostics& m_diagnostics;
    bool m_good = true;
};

bool hasMechanics(const JointStatement& joint) {
    const bool known =
        joint.type != JointType::Convel && joint.type != JointType::Screw && joint.type != JointType::Rackpin;
    return known && !joint.ic && !joint.icTranslation && !joint.icRotation;
}

}  // namespace

bool checkSimulated(const Dataset& dataset, Diagnostics& diagnostics) {
    Check check(diagnostics);
    check.refuseAll("POINT_MASS", dataset.pointMasses);
    for (const JointStatement& joint : dataset.joints)
        if (!hasMechanics(joint)) check.refuse("JOINT", joint);
    check.refuseAll("GCON", dataset.gcons);
    check.refuseAll("MOTION", dataset.motions);
    check.refuseAll("COUPLER", dataset.couplers);
    check.refuseAll("SFORCE", dataset.sforces);
    for (const VectorForceStatement& force : dataset.vectorForces)
        check.refuse(getAdamsName(force.type), force);
    check.refuseAll("SPRINGDAMPER", dataset.springdampers);
    check.refuseAll("BUSHING", dataset.bushings);
    check.refuseAll("VARIABLE", dataset.variables);
    check.refuseAll("SPLINE", dataset.splines);
    check.refuseAll("SENSOR", dataset.sensors);
    for (const RequestStatement& request : dataset.requests)
        if (request.type == RequestType::Expressions)
            diagnostics.push_back({Severity::Warning, request.where,
                                   fmt::format("REQUEST/{}: function expressions are not evaluated yet; this "
                                               "request writes nothing",
                                               request.id)});
    return check.isGood();
}

}  // namespace jprim
