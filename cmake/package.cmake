# `cpack -G DEB` in a build folder makes one package of everything that is installed. Dependencies are those of the
# program; a program of one's own that links the library needs the packages that cmake/packages.txt lists for building.
set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME texbake)
set(CPACK_PACKAGE_VERSION ${PROJECT_VERSION})
set(CPACK_PACKAGE_CONTACT "texbake <texbake@localhost>")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "bakes a photograph of a surface into an endless texture that does not repeat")
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_DEBIAN_COMPRESSION_TYPE zstd)  # xz takes minutes for the libraries
set(CPACK_VERBATIM_VARIABLES ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SECTION graphics)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)

file(STRINGS ${CMAKE_CURRENT_LIST_DIR}/packages.txt lines REGEX "^build ")
list(JOIN lines " " needed)
string(REGEX MATCHALL "[a-z0-9.+-]+-dev" needed "${needed}")
list(JOIN needed ", " needed)
set(CPACK_DEBIAN_PACKAGE_SUGGESTS "libegl1, g++, cmake, ${needed}")

install(FILES ${PROJECT_SOURCE_DIR}/LICENSE DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/texbake RENAME copyright)
include(CPack)
