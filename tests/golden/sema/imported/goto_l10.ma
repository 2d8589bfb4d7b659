behavior_name=goto_list
<start:b_arg>
    b_arg: num_waypoints(nodim) 2
    b_arg: initial_wpt(enum)    0
<end:b_arg>
<start:waypoints>
# LON LAT
713.000  5433.500
-725.80 -5418.   # south-west
<end:waypoints>
