# Aerial photographs against each other, against an orthophoto made of one of them, and with matches from a file.
include(${CMAKE_CURRENT_LIST_DIR}/expect.cmake)
require_data(aerial_ngi/ngi_xyz_opk.csv)

set(ngi ${DATA}/aerial_ngi)
set(first 3324c_2015_1004_05_0182_RGB)
set(second 3324c_2015_1004_05_0184_RGB)
set(map --dem=${ngi}/dem.tif --poses=${ngi}/ngi_xyz_opk.csv "--camera=833.333333 833.333333 319.5 575.5")
set(methods --methods=SQPNP,GMLPNP_MARGINAL --features=4000)
set(out ${WORK_DIR}/out)

# 5 m to a pixel, 4.7 km above ground, 24 m between elevations.
expect(0 "2 pairs, 0 without.*GMLPNP_MARGINAL \\| +2 \\| +0 \\| +0\\.[01][0-9]+ .*position \\[m\\].*GMLPNP_MARGINAL \\| +2 \\| +0 \\| +0\\.[01][0-9]+ \\| +0\\.[01][0-9]+ \\| +[0-9]\\.[0-9]+ .*The truth lies"
       ${PROGRAM} ${ngi}/${first}.tif ${ngi}/${second}.tif --reference=${ngi}/${first}.tif,${ngi}/${second}.tif ${map}
       ${methods} --residuals --output=${out})
foreach(name table.md errors.csv residuals.md residuals.csv positions.csv map_${first}_by_${second}.csv
        map_${first}_by_${second}.asc)
  if(NOT EXISTS ${out}/${name})
    message(FATAL_ERROR "no ${name}")
  endif()
endforeach()
expect_drawn(${out} errors.png residuals.png map_${first}_by_${second}.png map_${second}_by_${first}.png)

# An orthophoto of the second photograph, then without any true pose: positions only.
expect(0 "pixels of 6\\.[0-9]+ m" ${MAKE_ORTHOPHOTO} ${ngi}/${second}.tif ${WORK_DIR}/ortho.tif ${map})
expect(0 "1 pairs, 0 without.*position \\[m\\].*GMLPNP_MARGINAL \\| +1 \\| +0 \\| +0\\.00[0-9]+ \\| +0\\.00[0-9]+ \\| +[01]\\.[0-9]+ .*1 of 1"
       ${PROGRAM} ${ngi}/${second}.tif --orthophoto=${WORK_DIR}/ortho.tif ${map} ${methods})
list(REMOVE_ITEM map --poses=${ngi}/ngi_xyz_opk.csv)
expect(0 "GMLPNP_MARGINAL \\| +1 \\| +0 .*_by_ortho \\| +[0-9]+ \\| +-577[01][0-9]\\.[0-9]+ \\| +-37274[0-9][0-9]\\.[0-9]+ \\| +52[0-9][0-9]\\."
       ${PROGRAM} ${ngi}/${second}.tif --orthophoto=${WORK_DIR}/ortho.tif ${map} ${methods})
expect(1 "--residuals: --poses does not know" ${PROGRAM} ${ngi}/${second}.tif --orthophoto=${WORK_DIR}/ortho.tif ${map}
       --residuals)
