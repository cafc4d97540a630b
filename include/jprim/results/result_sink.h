// SPDX-License-Identifier: Apache-2.0
#ifndef JPRIM_RESULTS_RESULT_SINK_H_
#define JPRIM_RESULTS_RESULT_SINK_H_

#include <string>
#include <vector>

namespace jprim {

/// One value for each of the three tables of a simulation's results.
/// - requests, after `R<id>.` or RESULTS_NAME and a point, the name in CNAMES, and where there is none, or it is taken
///   already: for DISPLACEMENT MAG X Y Z PSI THETA PHI, for VELOCITY VM VX VY VZ WM WX WY WZ,
///   for ACCELERATION ACCM ACCX ACCY ACCZ WDTM WDTX WDTY WDTZ, for FORCE FM FX FY FZ TM TX TY TZ,
///   for functions F1 … F8
/// - reactions, after `JPRIM/<id>.I.` and `.J.` and likewise JOINT: FX FY FZ TX TY TZ, Ground axes, at the
///   marker
/// - parts, after `PART/<id>.`: X Y Z of the mass centre, E0 E1 E2 E3 of the CM marker, VX VY VZ WX WY WZ in
///   Ground; likewise after `FLEX_BODY/<id>.`, and the modal coordinates Q1 Q2 …; after `energy.`: kinetic
///   potential total; after `error.`: the largest errors of constraints, length and angle
template <class Value>
struct TypedResultTables {
    Value requests;
    Value reactions;
    Value parts;
};

/// The names of the columns; the first is `time`.
using ResultColumns = TypedResultTables<std::vector<std::string>>;
/// A value for each column, in the dataset's units, angles in radians.
using ResultRow = TypedResultTables<std::vector<double>>;

/// Takes results as they are recorded, one row at each output time.
class ResultSink {
public:
    virtual ~ResultSink() = default;

    /// Called once, before the first row.
    virtual void begin(const ResultColumns& columns) = 0;
    virtual void add(const ResultRow& row) = 0;
};

}  // namespace jprim

#endif
