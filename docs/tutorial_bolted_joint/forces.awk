BEGIN { FS = "," }
NR == 2 || NR % 8 == 3 { printf "%6.0f h   bolt %5.1f kN   clamping %5.1f kN   %3.0f MPa\n", $1, $2/1e3, $3/1e3, $4 }
