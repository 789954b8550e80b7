// SPDX-License-Identifier: Apache-2.0
#pragma once
// The parts of the report's page that Markdown has not: the table of claims with its filter, and
// the viewer of meshes. Style and scripts are the files of paper/page/.

#include <string>
#include <vector>

#include "paper/claims_list.hpp"
#include "paper/document.hpp"
#include "paper/viewer_mesh.hpp"

namespace quadbound {

/// A row per claim with its anchor as id, and a button per verdict. On paper a plain table.
/// Guarantees: 1. every verdict stands there in words. 2. `links` are those of claim_links().
PageBlock claims_block(const std::vector<ListedClaim>& claims, const std::vector<ClaimLink>& links);

/// The viewer with its meshes; on paper nothing. Requires: the views' meshes are among `meshes`; at
/// least one view.
PageBlock viewer_block(const std::vector<ViewerMesh>& meshes, const std::vector<ViewerView>& views);

PageFrame report_frame(const std::string& title);

}  // namespace quadbound
