# Run by cpack on the staged files: what Debian wants in another form than `cmake --install` makes it.
file(GLOB_RECURSE pages ${CPACK_TEMPORARY_DIRECTORY}/creepcontact.1)
file(GLOB_RECURSE changelogs ${CPACK_TEMPORARY_DIRECTORY}/CHANGELOG.md)
foreach(changelog IN LISTS changelogs)
  get_filename_component(directory ${changelog} DIRECTORY)
  file(COPY_FILE ${changelog} ${directory}/changelog)
  list(APPEND pages ${directory}/changelog)
  file(REMOVE ${directory}/LICENSE)
endforeach()
file(GLOB_RECURSE copyrights ${CPACK_TEMPORARY_DIRECTORY}/copyright)
foreach(copyright IN LISTS copyrights)
  file(WRITE ${copyright} "creepcontact: creep of machine parts in contact
Copyright: the creepcontact developers
License: GPL-3.0-only
 The text of the GNU General Public License, version 3, is in /usr/share/common-licenses/GPL-3.
 The interactive view of reports contains three.js (MIT License, Copyright 2010-2026 three.js authors).
")
endforeach()
foreach(page IN LISTS pages)
  execute_process(COMMAND gzip -9nf ${page} COMMAND_ERROR_IS_FATAL ANY)
endforeach()
