# Run by CPack before it builds the packages: adds what Debian's policy asks of each package (copyright, changelog, compressed
# manual pages) and moves what Debian keeps in other folders. CHANGELOG.md is the source of the Debian changelog.
function(compress file)
  execute_process(COMMAND gzip -9n ${file} COMMAND_ERROR_IS_FATAL ANY)
endfunction()

# The changelog of the Debian package: the newest version and date of CHANGELOG.md.
function(write_debian_changelog file)
  file(STRINGS ${CPACK_RAYSCOPE_SOURCE}/CHANGELOG.md versions REGEX "^## .* \\(.*\\)$")
  list(GET versions 0 newest)
  if(NOT newest MATCHES "^## ([0-9.]+) \\(([0-9-]+)\\)$" OR NOT CMAKE_MATCH_1 STREQUAL CPACK_PACKAGE_VERSION)
    message(FATAL_ERROR "The first version of CHANGELOG.md ('${newest}') is not ${CPACK_PACKAGE_VERSION}")
  endif()
  execute_process(COMMAND date --utc --rfc-email --date ${CMAKE_MATCH_2} OUTPUT_VARIABLE date
                  OUTPUT_STRIP_TRAILING_WHITESPACE COMMAND_ERROR_IS_FATAL ANY)
  file(WRITE ${file} "rayscope (${CPACK_PACKAGE_VERSION}-${CPACK_DEBIAN_PACKAGE_RELEASE}) unstable; urgency=medium\n\n"
    "  * Version ${CPACK_PACKAGE_VERSION}; changelog.gz lists the changes.\n\n"
    " -- ${CPACK_DEBIAN_PACKAGE_MAINTAINER}  ${date}\n")
  compress(${file})
endfunction()

function(add_documents package prefix)
  set(folder ${prefix}/share/doc/${package})
  file(MAKE_DIRECTORY ${folder} ${prefix}/share/lintian/overrides)
  # These packages are no uploads to Debian, which a bug report would request.
  file(WRITE ${prefix}/share/lintian/overrides/${package} "${package}: initial-upload-closes-no-bugs\n")
  file(REMOVE ${folder}/LICENSE) # part of copyright
  file(COPY ${CPACK_RAYSCOPE_SOURCE}/packaging/copyright DESTINATION ${folder})
  file(COPY_FILE ${CPACK_RAYSCOPE_SOURCE}/CHANGELOG.md ${folder}/changelog)
  file(REMOVE ${folder}/CHANGELOG.md)
  compress(${folder}/changelog)
  write_debian_changelog(${folder}/changelog.Debian)
endfunction()

set(program ${CPACK_TEMPORARY_DIRECTORY}/program/usr)
set(development ${CPACK_TEMPORARY_DIRECTORY}/development/usr)
add_documents(rayscope ${program})
add_documents(librayscope-dev ${development})
compress(${program}/share/man/man1/rayscope.1)
file(RENAME ${program}/share/zsh/site-functions ${program}/share/zsh/vendor-completions)
file(GLOB_RECURSE archives ${development}/*.a)
execute_process(COMMAND ${CPACK_RAYSCOPE_STRIP} --strip-debug --remove-section=.comment --remove-section=.note
                        --enable-deterministic-archives ${archives} COMMAND_ERROR_IS_FATAL ANY)
