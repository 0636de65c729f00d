# Installs the programs under any prefix, in two components: vantage and vantage-player. The programs find
# their files relative to themselves (pipeline/run/config_files.cpp, pipeline/photos/image_files.cpp).
set(CMAKE_SKIP_INSTALL_ALL_DEPENDENCY ON)  # only the programs and the manual must be built
set(manual ${CMAKE_BINARY_DIR}/manual)

install(TARGETS vantage RUNTIME DESTINATION bin COMPONENT vantage)
install(TARGETS vantage_images LIBRARY DESTINATION lib/vantage COMPONENT vantage)
install(DIRECTORY configs DESTINATION share/vantage COMPONENT vantage USE_SOURCE_PERMISSIONS PATTERN desktop EXCLUDE)
install(FILES configs/desktop/vantage.thumbnailer DESTINATION share/thumbnailers COMPONENT vantage)
install(DIRECTORY ${manual}/man1 DESTINATION share/man COMPONENT vantage PATTERN vantage-player* EXCLUDE)

install(TARGETS vantage-player RUNTIME DESTINATION bin COMPONENT vantage-player)
install(DIRECTORY ${CMAKE_BINARY_DIR}/share/locale DESTINATION share COMPONENT vantage-player)
install(FILES configs/desktop/vantage-player.desktop DESTINATION share/applications COMPONENT vantage-player)
install(FILES configs/desktop/vantage.svg DESTINATION share/icons/hicolor/scalable/apps COMPONENT vantage-player)
install(FILES configs/desktop/vantage.xml DESTINATION share/mime/packages COMPONENT vantage-player)
install(DIRECTORY ${manual}/man1 DESTINATION share/man COMPONENT vantage-player FILES_MATCHING PATTERN vantage-player*)

foreach(program vantage vantage-player)
  install(FILES ${manual}/bash/${program} DESTINATION share/bash-completion/completions COMPONENT ${program})
  install(FILES ${manual}/zsh/_${program} DESTINATION share/zsh/vendor-completions COMPONENT ${program})
  install(FILES LICENSE DESTINATION share/doc/${program} RENAME copyright COMPONENT ${program})
endforeach()

# The documents keep their relative locations, so that links between them work.
install(FILES README.md CHANGELOG.md LICENSE DESTINATION share/doc/vantage COMPONENT vantage)
install(FILES scene/package/FORMAT.md DESTINATION share/doc/vantage/scene/package COMPONENT vantage)
install(DIRECTORY docs data DESTINATION share/doc/vantage COMPONENT vantage)

# In the build folder, `cpack -G DEB` makes two Debian packages.
set(CPACK_COMPONENTS_ALL vantage vantage-player)
set(CPACK_PACKAGE_CONTACT "Vantage maintainers <maintainers@example.org>")
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PACKAGE_SECTION graphics)
set(CPACK_DEBIAN_PACKAGE_CONTROL_STRICT_PERMISSION ON)

set(CPACK_COMPONENT_VANTAGE_DESCRIPTION "prepare scans and their photos for viewing
vantage combines a mesh or a point cloud and its calibrated photos into one
package, which vantage-player shows through the photos themselves. It also
checks, compares and extracts packages, and writes their thumbnails for file
managers.")
set(CPACK_DEBIAN_VANTAGE_PACKAGE_NAME vantage)
set(CPACK_DEBIAN_VANTAGE_PACKAGE_RECOMMENDS vantage-player)

set(CPACK_COMPONENT_VANTAGE-PLAYER_DESCRIPTION "view scanned objects through their own photos
vantage-player opens a package that vantage has prepared, and blends the
photos on the model for the current viewpoint. Nothing is baked into a
texture, so no detail of the photos is lost. It needs OpenGL 4.5, in hardware
or by Mesa's software renderer.")
set(CPACK_DEBIAN_VANTAGE-PLAYER_PACKAGE_NAME vantage-player)
# These libraries are loaded at run time, so no program header lists them.
set(CPACK_DEBIAN_VANTAGE-PLAYER_PACKAGE_DEPENDS "libegl1, libgl1")
set(CPACK_DEBIAN_VANTAGE-PLAYER_PACKAGE_RECOMMENDS "fonts-dejavu-core, libgl1-mesa-dri, shared-mime-info")
set(CPACK_DEBIAN_VANTAGE-PLAYER_PACKAGE_SUGGESTS "ffmpeg, vantage")
include(CPack)
