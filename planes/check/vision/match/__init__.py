"""What is read off a picture of each kind of plan: motion, scheme, forces, a printed drawing."""
