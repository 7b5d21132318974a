#!/bin/sh
# kernel_costs.sh BUILD: nanoseconds of one intersection test, by three kinds of kernels in turn;
# the median of seven, and the ratio to the textbook's.
build=$1
for round in 1 2 3 4 5 6 7; do
    for kernels in textbook references exact; do
        "$build/kernel_costs_of_$kernels" | sed "s/^/$kernels /"
    done
done | sort -k1,2 -k3n | awk '
    { costs[$1, $2] = costs[$1, $2] " " $3 }
    END {
        print "| | textbook, ns | reference | exact |"
        print "|---|---|---|---|"
        split("sphere plane triangle square cylinder cone", shapes)
        for (i = 1; i <= 6; ++i) {
            shape = shapes[i]
            split(costs["textbook", shape], textbook)
            split(costs["references", shape], reference)
            split(costs["exact", shape], exact)
            printf "| %s | %.1f | %.1f, %.1f× | %.1f, %.1f× |\n", shape, textbook[4],
                reference[4], reference[4] / textbook[4], exact[4], exact[4] / textbook[4]
        }
    }'
