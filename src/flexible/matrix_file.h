// SPDX-License-Identifier: Apache-2.0
#ifndef JPRIM_SRC_FLEXIBLE_MATRIX_FILE_H_
#define JPRIM_SRC_FLEXIBLE_MATRIX_FILE_H_

#include <string>
#include <vector>

#include "jprim/flexible/finite_element_model.h"

namespace jprim {

/// Reads a symmetric matrix from lines `row column value`, counted from 1, and returns both its triangles.
/// A file with off-diagonal terms on one side only holds one triangle. No row may lack its diagonal term, and
/// no term may stand there twice.
/// @param freedoms  the model's freedom of each row; the matrix has as many rows
/// @param remedy    ends messages about the file as a whole: how it is written
/// @throws Error with file and line
std::vector<MatrixTerm> readMatrixFile(const std::string& path, const std::vector<int>& freedoms,
                                       const std::string& remedy);

/// The lines of a matrix file that hold a term, rows and columns counted from 1.
std::vector<int> findLinesOfTerm(const std::string& path, int row, int column);

}  // namespace jprim

#endif
