# What CPack 3.25 has no word for: packages of several architectures beside each other, the changelog where Debian has it,
# the linker's cache by the trigger alone, for CPack would have scripts call ldconfig besides, and folders that everybody can
# read, whatever the umask was.
list(FILTER CPACK_PACKAGE_FILES INCLUDE REGEX "\\.deb$")
foreach(package IN LISTS CPACK_PACKAGE_FILES)
  set(tree ${package}.tree)
  file(REMOVE_RECURSE ${tree})
  execute_process(COMMAND dpkg-deb --raw-extract ${package} ${tree} COMMAND_ERROR_IS_FATAL ANY)
  file(REMOVE ${tree}/DEBIAN/postinst ${tree}/DEBIAN/postrm)
  execute_process(COMMAND chmod -R u=rwX,go=rX ${tree} COMMAND_ERROR_IS_FATAL ANY)
  file(READ ${tree}/DEBIAN/control control)
  string(REPLACE "\nArchitecture:" "\nMulti-Arch: same\nArchitecture:" control "\n${control}")
  string(STRIP "${control}" control)
  file(WRITE ${tree}/DEBIAN/control "${control}\n")

  file(GLOB changelog ${tree}/usr/share/doc/*/CHANGELOG.md)
  cmake_path(REPLACE_FILENAME changelog changelog OUTPUT_VARIABLE renamed)  # which gzip makes changelog.gz
  file(RENAME ${changelog} ${renamed})
  execute_process(COMMAND gzip -9n ${renamed} COMMAND_ERROR_IS_FATAL ANY)

  execute_process(COMMAND find usr -type f -exec md5sum {} + WORKING_DIRECTORY ${tree}
                  OUTPUT_FILE ${tree}/DEBIAN/md5sums COMMAND_ERROR_IS_FATAL ANY)
  execute_process(COMMAND dpkg-deb --root-owner-group --build ${tree} ${package} COMMAND_ERROR_IS_FATAL ANY)
  file(REMOVE_RECURSE ${tree})
endforeach()
