# What a person gets to read of a mesh whose faces were refined, all of them: no cell, as there was none.
"$WINNOW" generate scan --faces 20000 -o scan.ply -q
"$WINNOW" simplify scan.ply -o small.ply --faces 3001
