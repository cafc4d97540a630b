// SPDX-License-Identifier: Apache-2.0
// Speeds u with G u = b that minimize first |C u - c|, then the size of what moves, where the rows of C pick the
// given components c and b is what time-dependent constraints demand. The size is that of V = A u, the
// velocities of all mass centres and the angular velocities times the parts' sizes. Speeds of modes have zeros
// in S: they are at rest.
//
//     A = Q R,  u = S y with S = inverse of R,  so that |y| = |V|
//     (G S) p = b,  Z spans the null space of G S,  y = p + Z x,
//     x = least-norm least-squares of (C S Z) x = c - C S p
//
// None of this is needed if the velocities given, with zero for what is not, are a motion that the joints allow.
#include "simulation/initial_velocities.h"

#include <algorithm>

#include "jprim/marker/marker_pair.h"
#include "linear_algebra/conversion.h"
#include "linear_algebra/orthogonal.h"
#include "linear_algebra/ranked_rows.h"
#include "simulation/assembly_conditions.h"
#include "simulation/constraint_jacobian.h"
#include "simulation/coordinate_direction.h"

namespace jprim {

using SimTK::Real;
using SimTK::SpatialVec;
using SimTK::State;
using SimTK::Vec3;
using SimTK::Vector;

namespace {

// Given velocities count as admissible if they violate the constraints by no more than rounding.
constexpr double Admissible = 1e-12;
// Of given velocities: what depends on others cancels to about the assembly tolerance.
constexpr double RankTolerance = 1e-8;

struct GivenVelocities {
    Eigen::MatrixXd C;
    Eigen::VectorXd c;
};

bool isRateGiven(const Mechanism& mechanism, const InitialCoordinate& given, const State& state) {
    return given.rate && !isSwitchedOff(mechanism, given, state);
}

/// Collects the rows of C.
class Collector {
public:
    Collector(const Mechanism& mechanism, const State& state)
        : m_matter(mechanism.getMatter()), m_state(state) {
        for (const MechanismPart& part : mechanism.getParts())
            if (!part.ground) addPart(part);
        for (const InitialCoordinate& given : mechanism.getInitialCoordinates())
            if (isRateGiven(mechanism, given, state))
                addRate(given.coordinate.getImplementation(), *given.rate);
    }

    GivenVelocities finish() {
        m_given.C.resize(Eigen::Index(m_rows.size()), m_state.getNU());
        for (size_t i = 0; i < m_rows.size(); ++i) m_given.C.row(Eigen::Index(i)) = m_rows[i];
        m_given.c = Eigen::Map<Eigen::VectorXd>(m_values.data(), Eigen::Index(m_values.size()));
        return std::move(m_given);
    }

private:
    void addPart(const MechanismPart& part) {
        const SimTK::Rotation R_GV = part.vm.findPoseInGround(m_state).R();
        const SimTK::Rotation R_GW = part.wm.findPoseInGround(m_state).R();
        for (int k = 0; k < 3; ++k) {
            if (part.w[k] && part.turns)
                addRow(part, SpatialVec(part.size * Vec3(R_GW(k)), Vec3(0)), part.size * *part.w[k]);
            if (part.v[k]) addRow(part, SpatialVec(Vec3(0), Vec3(R_GV(k))), *part.v[k]);
        }
    }

    // The row that multiplies u to direction . V of the part's body.
    void addRow(const MechanismPart& part, const SpatialVec& direction, Real value) {
        Directions directions(m_matter, m_state);
        directions.onBodies[part.body.getMobilizedBodyIndex()] = direction;
        addRow(directions, value);
    }

    void addRow(const Directions& directions, Real value) {
        Vector row;
        m_matter.multiplyBySystemJacobianTranspose(m_state, directions.onBodies, row);
        row += directions.onSpeeds;
        m_rows.emplace_back(Eigen::Map<const Eigen::VectorXd>(&row[0], row.size()));
        m_values.push_back(value);
    }

    void addRate(const MarkerExpression& q, Real rate) {
        Directions directions(m_matter, m_state);
        addCoordinateDirections(q, m_state, directions);
        addRow(directions, rate);
    }

    const SimTK::SimbodyMatterSubsystem& m_matter;
    const State& m_state;
    GivenVelocities m_given;
    std::vector<Eigen::VectorXd> m_rows;
    std::vector<Real> m_values;
};

// G u - b, of the equations on velocities.
Eigen::VectorXd calcErrors(const Mechanism& mechanism, State& state, const Vector& u) {
    state.updU() = u;
    mechanism.getSystem().realize(state, SimTK::Stage::Velocity);
    return toEigen(state.getUErr());
}

// y, see above.
Eigen::VectorXd solve(const Eigen::MatrixXd& GS, const Eigen::VectorXd& b, const Eigen::MatrixXd& CS,
                      const Eigen::VectorXd& c) {
    Eigen::VectorXd p = Eigen::VectorXd::Zero(GS.cols());
    const RankedRows rows(GS);
    if (!b.isZero(0)) p = rows.solve(b);
    const Eigen::MatrixXd Z = rows.calcNullSpace();
    const Eigen::MatrixXd CSZ = CS * Z;
    if (Z.cols() == 0 || CSZ.norm() < RankTolerance) return p;
    return p + Z * solveLeastNorm(CSZ, c - CS * p, RankTolerance);
}

// S, see above; its rows are those of u, its columns those of the speeds of parts.
Eigen::MatrixXd calcS(const Mechanism& mechanism, const State& state) {
    SimTK::Matrix J;  // [w, v] of each body
    mechanism.getMatter().calcSystemJacobian(state, J);
    std::vector<Eigen::Index> rows, speeds;
    std::vector<double> weights;
    for (const MechanismPart& part : mechanism.getParts()) {
        if (part.ground) continue;
        for (int k = 0; k < 6; ++k) {
            rows.push_back(6 * part.body.getMobilizedBodyIndex() + k);
            weights.push_back(k < 3 ? part.size : 1);
        }
        for (int k = 0; k < part.body.getNumU(state); ++k)
            speeds.push_back(part.body.getFirstUIndex(state) + k);
    }
    const auto n = Eigen::Index(speeds.size());
    Eigen::MatrixXd S = Eigen::MatrixXd::Zero(state.getNU(), n);
    const Eigen::Map<const Eigen::MatrixXd> all(&J(0, 0), J.nrow(), J.ncol());
    const Eigen::Map<const Eigen::VectorXd> W(weights.data(), Eigen::Index(weights.size()));
    S(speeds, Eigen::all) = calcOrthonormalizer(W.asDiagonal() * all(rows, speeds));
    return S;
}

// The velocities given for a part, with zero for what is not.
SpatialVec findGivenVelocity(const MechanismPart& part, const State& state) {
    const auto fill = [](const std::array<std::optional<Real>, 3>& given) {
        return Vec3(given[0].value_or(0), given[1].value_or(0), given[2].value_or(0));
    };
    const Vec3 w = part.turns ? fill(part.w) : Vec3(0);
    return {part.wm.findPoseInGround(state).R() * w, part.vm.findPoseInGround(state).R() * fill(part.v)};
}

// The speeds that come nearest to the velocities given, each joint by itself.
Vector fitGivenVelocities(const Mechanism& mechanism, const State& state) {
    SimTK::Vector_<SpatialVec> V(mechanism.getMatter().getNumBodies(), SpatialVec(Vec3(0), Vec3(0)));
    for (const MechanismPart& part : mechanism.getParts())
        if (!part.ground) V[part.body.getMobilizedBodyIndex()] = findGivenVelocity(part, state);
    State fitted = state;  // fitting makes a State forget its positions
    mechanism.getSystem().realize(fitted, SimTK::Stage::Position);
    for (const MechanismPart& part : mechanism.getParts()) {
        if (part.ground) continue;
        const SimTK::MobilizedBody& parent = part.body.getParentMobilizedBody();
        const auto findMotion = [&](const SimTK::MobilizedBody& body, const SimTK::Transform& X_BF) {
            const Vec3 lever = body.getBodyRotation(state) * X_BF.p();
            const SpatialVec& V_GB = V[body.getMobilizedBodyIndex()];
            return std::pair(body.getBodyTransform(state) * X_BF,
                             SpatialVec(V_GB[0], V_GB[1] + V_GB[0] % lever));
        };
        const auto [X_GF, V_GF] = findMotion(parent, part.body.getInboardFrame(state));
        const auto [X_GM, V_GM] = findMotion(part.body, part.body.getOutboardFrame(state));
        part.body.setUToFitVelocity(fitted, MarkerPair(X_GM, X_GF).calcVelocity(V_GM, V_GF));
    }
    return fitted.getU();
}

// True if the speeds violate the constraints, and miss what is given or should be at rest, by no more than
// rounding.
bool isAdmissible(const Mechanism& mechanism, State& state, const Vector& u) {
    const double errors = calcErrors(mechanism, state, u).norm();
    double missed = 0, largest = 0;
    for (const MechanismPart& part : mechanism.getParts()) {
        if (part.ground) continue;
        const SpatialVec given = findGivenVelocity(part, state);
        const SpatialVec miss = part.body.getBodyVelocity(state) - given;
        missed = std::max({missed, part.size * miss[0].norm(), miss[1].norm()});
        largest = std::max({largest, part.size * given[0].norm(), given[1].norm()});
    }
    return errors <= Admissible * u.norm() && missed <= Admissible * largest;
}

}  // namespace

Vector calcInitialVelocities(const Mechanism& mechanism, const State& positions) {
    if (positions.getNU() == 0) return Vector();
    State state = positions;
    mechanism.getSystem().realize(state, SimTK::Stage::Position);  // a copy has forgotten that it was
    const std::vector<InitialCoordinate>& coordinates = mechanism.getInitialCoordinates();
    if (std::none_of(coordinates.begin(), coordinates.end(),
                     [&](const auto& given) { return isRateGiven(mechanism, given, state); })) {
        const Vector fitted = fitGivenVelocities(mechanism, state);
        if (isAdmissible(mechanism, state, fitted)) return fitted;
    }
    const Eigen::VectorXd b = -calcErrors(mechanism, state, Vector(state.getNU(), Real(0)));
    const GivenVelocities given = Collector(mechanism, state).finish();
    const Eigen::MatrixXd S = calcS(mechanism, state);
    const SpeedEquations equations(mechanism, state);
    const Eigen::VectorXd u = S * solve(equations.getG() * S, equations.unscale(b), given.C * S, given.c);
    return toSimTK(u);
}

}  // namespace jprim
