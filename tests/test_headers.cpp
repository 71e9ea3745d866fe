// Nothing: what the test programs share is the precompiled header of this file's target.
