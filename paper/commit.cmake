# SPDX-License-Identifier: Apache-2.0
# Writes OUTPUT, a header with what `git describe` says of SOURCE; untouched where it says the same.
execute_process(COMMAND git -C ${SOURCE} describe --always --dirty --abbrev=12
                OUTPUT_VARIABLE commit OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET
                RESULT_VARIABLE failed)
if(failed)
  set(commit unknown)
endif()
set(text "// SPDX-License-Identifier: Apache-2.0\n#pragma once\n\nnamespace quadbound {\ninline constexpr const char* kCommit = \"${commit}\";\n}\n")
set(before "")
if(EXISTS ${OUTPUT})
  file(READ ${OUTPUT} before)
endif()
if(NOT before STREQUAL text)
  file(WRITE ${OUTPUT} "${text}")
endif()
