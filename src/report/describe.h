// SPDX-License-Identifier: Apache-2.0
#ifndef JPRIM_SRC_REPORT_DESCRIBE_H_
#define JPRIM_SRC_REPORT_DESCRIBE_H_

#include "jprim/report/write_report.h"
#include "report/motion.h"
#include "report/report_data.h"

/// @file
/// The pieces of a report, one function for each file of this folder that begins with describe_.
namespace jprim {

/// x y z and Euler parameters.
void appendPose(const SimTK::Transform& X, std::vector<float>& numbers);
Json makeJson(const SimTK::Vec3& v);
Json makeJson(const SimTK::Transform& X);

/// Parts, markers and elements: what a report needs of a Mechanism.
void describeMechanism(const Dataset& dataset, const Mechanism& mechanism, const Motion& motion,
                       const Results& results, Json& json);
/// GRAPHICS that are drawn.
Json describeGraphics(const Dataset& dataset, const Mechanism& mechanism, const Motion& motion);
/// Bodies that deform.
Json describeFlexible(const Mechanism& mechanism, const Motion& motion, size_t stride, ReportData& data);

/// Curves, as many as fit into this many bytes.
/// @param[out] omitted  what did not fit, in words
Json describeTables(const Dataset& dataset, const Mechanism& mechanism, const Results& results, size_t bytes,
                    ReportData& data, std::vector<std::string>& omitted);

}  // namespace jprim

#endif
