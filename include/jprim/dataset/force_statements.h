// SPDX-License-Identifier: Apache-2.0
#ifndef JPRIM_DATASET_FORCE_STATEMENTS_H_
#define JPRIM_DATASET_FORCE_STATEMENTS_H_

#include <array>
#include <optional>

#include "jprim/base/diagnostic.h"
#include "jprim/dataset/source_text.h"

/// @file
/// The statements of a dataset that apply forces: SFORCE, VFORCE, VTORQUE, GFORCE, SPRINGDAMPER, BUSHING. I
/// and J are markers of different bodies unless it is said otherwise. What holds for all statements is said
/// in dataset.h.
namespace jprim {

using Triple = std::array<double, 3>;

/// SFORCE: a force along a line or a torque about an axis.
struct SforceStatement {
    SourcePosition where;
    int id = 0;
    int i = 0;  ///< where it acts
    int j = 0;  ///< where it reacts; on any body, that of I too, if actionOnly
    bool rotational = false;
    /// No reaction on J. A translational force then points along zJ, instead of from J to I.
    bool actionOnly = false;
    ExpressionText function;  ///< translational: positive pushes I and J apart; rotational: turns I about zJ
};

enum class VectorForceType { Vforce, Vtorque, Gforce };

/// VFORCE, VTORQUE or GFORCE: force and torque on I in the axes of a marker, and their reaction where I is
/// at that instant. Each of the three types has ids of its own.
struct VectorForceStatement {
    SourcePosition where;
    VectorForceType type = VectorForceType::Vforce;
    int id = 0;
    int i = 0;
    int jfloat = 0;  ///< a floating marker of the body that feels the reaction
    int rm = 0;      ///< marker whose axes the components are along; ground axes if 0
    /// FX, FY, FZ, TX, TY, TZ; one that is not given is 0. At least one is given here or below.
    std::array<std::optional<ExpressionText>, 6> components;
    std::optional<ExpressionText> fxyz;  ///< FXYZ: the force as one vector; excludes FX, FY, FZ
    std::optional<ExpressionText> txyz;  ///< TXYZ: the torque as one vector; excludes TX, TY, TZ
};

/// SPRINGDAMPER: a linear spring and damper along the line from J to I, or about the common z axis.
///   translational: F = -damping VR - stiffness (DM - freeLength) + preload, positive pushes apart
///   rotational:    T = -damping WZ - stiffness (AZ - freeLength) + preload, on I about zJ
struct SpringdamperStatement {
    SourcePosition where;
    int id = 0;
    int i = 0;
    int j = 0;
    bool rotational = false;
    double stiffness = 0;   ///< K or KT [force/length or moment/rad]
    double damping = 0;     ///< C or CT
    double freeLength = 0;  ///< LENGTH or ANGLE
    double preload = 0;     ///< FORCE or TORQUE
};

/// BUSHING: springs and dampers along and about J's three axes, acting on I:
///   F = -k (x, y, z) - c (velocity of I seen from J) + force
///   T = -kt (angles of I in J) - ct (angular velocity of I in J) + torque
struct BushingStatement {
    SourcePosition where;
    int id = 0;
    int i = 0;
    int j = 0;
    Triple k{};   ///< K [force/length]
    Triple c{};   ///< C
    Triple kt{};  ///< KT [moment/rad]
    Triple ct{};  ///< CT
    Triple force{};
    Triple torque{};
};

/// The keyword of a type: "GFORCE".
const char* getAdamsName(VectorForceType type);

}  // namespace jprim

#endif
