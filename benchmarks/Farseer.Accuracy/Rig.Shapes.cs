using System;
using System.Collections.Generic;
using System.Numerics;
using FarseerGames.FarseerPhysics.Dynamics;
using FarseerGames.FarseerPhysics.Factories;

namespace Farseer.Accuracy;

/// <summary>A rectangle of a body of several, about its centre of mass.</summary>
internal readonly record struct Part(Vec Centre, double Width, double Height);

/// <content>Bodies of several rectangles, and capsules.</content>
internal sealed partial class Rig
{
    /// <summary>A body of several rectangles whose centre of mass is its origin.</summary>
    public Actor AddCompound(Vec position, double angle, double mass, double inertia, IReadOnlyList<Part> parts)
    {
        var pieces = new List<Vec[]>();
        foreach (Part part in parts)
        {
            pieces.Add(Outlines.Box(part.Width, part.Height, part.Centre));
        }

        Actor actor = Add(position, angle, mass, inertia, pieces, isStatic: false, out Body body);
        foreach (Part part in parts)
        {
            var offset = new Vector2((float)part.Centre.X, (float)part.Centre.Y);
            Attach(GeomFactory.Instance.CreateRectangleGeom(_simulator, body, (float)part.Width, (float)part.Height, offset, 0));
        }

        return actor;
    }

    /// <summary>All points within a radius of a line of a length along the body's x axis, of density 1.</summary>
    public Actor AddCapsule(Vec position, double angle, double length, double radius)
    {
        double middle = 2 * length * radius;
        double ends = Math.PI * radius * radius;

        // Each half disc about its own centre of mass, which is 4 r / 3 π beyond the end of the line, and then about the middle.
        double beyond = 4 * radius / (3 * Math.PI);
        double arm = (0.5 * length) + beyond;
        double inertia = (middle * ((length * length) + (4 * radius * radius)) / 12)
            + (ends * ((0.5 * radius * radius) - (beyond * beyond) + (arm * arm)));
        Actor actor = Add(position, angle, middle + ends, inertia, [], isStatic: false, out Body body);
        var end = new Vector2((float)(0.5 * length), 0);
        Attach(GeomFactory.Instance.CreateCapsuleGeom(_simulator, body, -end, end, (float)radius));
        return actor;
    }
}
