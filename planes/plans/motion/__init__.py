"""Plans of velocities and accelerations."""
