behavior_name=goto_list
<start:b_arg>
    b_arg: num_legs_to_run(nodim) -2
    b_arg: initial_wpt(enum) -2   # closest
<end:b_arg>
<start:waypoints>
-7349.8 3910.5
-7346.8 3910.5
<end:waypoints>
