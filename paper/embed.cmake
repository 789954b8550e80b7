# SPDX-License-Identifier: Apache-2.0
# Writes OUTPUT, a header with the files of the report's page as strings; SCRIPTS become one.
set(text "// SPDX-License-Identifier: Apache-2.0\n#pragma once\n\n#include <string_view>\n\nnamespace quadbound {\n")

function(embed name)
  string(APPEND text "inline constexpr std::string_view ${name} =")
  foreach(path IN LISTS ARGN)
    file(READ ${path} part)
    string(APPEND text "\n    R\"page(${part})page\"")
  endforeach()
  set(text "${text};\n" PARENT_SCOPE)
endfunction()

embed(kClaimsFile ${SOURCE}/claims.json)
embed(kPageStyle ${SOURCE}/page/page.css)
embed(kPageViewer ${SOURCE}/page/viewer.html)
embed(kPageScript ${SCRIPTS})
file(WRITE ${OUTPUT} "${text}}  // namespace quadbound\n")
