using System;
using System.Collections.Generic;
using System.Linq;
using Farseer.Fidelity.Scenes;

namespace Farseer.Fidelity.Fine;

/// <summary>A body: its place is that of its centre of mass. What has an inverse mass of 0 stands still.</summary>
internal sealed class FineBody(string id)
{
    public string Id => id;

    public List<FineShape> Shapes { get; } = [];

    public double X { get; set; }

    public double Y { get; set; }

    public double Angle { get; set; }

    public double VelocityX { get; set; }

    public double VelocityY { get; set; }

    public double Spin { get; set; }

    public double InverseMass { get; set; }

    public double InverseInertia { get; set; }

    /// <summary>The centre of mass in the body's frame.</summary>
    public double LocalX { get; private set; }

    public double LocalY { get; private set; }

    public bool HasNoWeight { get; init; }

    /// <summary>The force -c v, the force -q |v| v, and the torque -r |w| w; and the rate by which velocity and spin decay.</summary>
    public (double Linear, double Quadratic, double Turning, double Decay, double TurningDecay) Drag { get; init; }

    public (double X, double Y) ToWorld((double X, double Y) local)
    {
        (double sin, double cos) = Math.SinCos(Angle);
        (double x, double y) = (local.X - LocalX, local.Y - LocalY);
        return (X + (cos * x) - (sin * y), Y + (sin * x) + (cos * y));
    }

    public (double X, double Y) ToLocal((double X, double Y) world)
    {
        (double sin, double cos) = Math.SinCos(Angle);
        (double x, double y) = (world.X - X, world.Y - Y);
        return ((cos * x) + (sin * y) + LocalX, (cos * y) - (sin * x) + LocalY);
    }

    public Row ToRow()
    {
        (double x, double y) = ToWorld((0, 0));
        return new Row(x, y, Angle, VelocityX, VelocityY, Spin);
    }

    public (double X, double Y) VelocityAt(double x, double y) => (VelocityX - (Spin * (y - Y)), VelocityY + (Spin * (x - X)));

    /// <summary>The change of velocity by an impulse at a point.</summary>
    public void Push(double x, double y, double impulseX, double impulseY)
    {
        VelocityX += InverseMass * impulseX;
        VelocityY += InverseMass * impulseY;
        Spin += InverseInertia * (((x - X) * impulseY) - ((y - Y) * impulseX));
    }

    public void Slow(double step)
    {
        double pull = (Drag.Linear + (Drag.Quadratic * Math.Sqrt((VelocityX * VelocityX) + (VelocityY * VelocityY)))) * InverseMass;
        double kept = Math.Exp(-step * (Drag.Decay + pull));
        VelocityX *= kept;
        VelocityY *= kept;
        Spin *= Math.Exp(-step * (Drag.TurningDecay + (Drag.Turning * Math.Abs(Spin) * InverseInertia)));
    }

    /// <summary>Puts the body's origin somewhere.</summary>
    public void MoveTo(double x, double y, double angle)
    {
        Angle = angle;
        (double sin, double cos) = Math.SinCos(angle);
        X = x + (cos * LocalX) - (sin * LocalY);
        Y = y + (sin * LocalX) + (cos * LocalY);
    }

    public void SetMassFromShapes()
    {
        (double originX, double originY) = ToWorld((0, 0));
        (double mass, double x, double y, double moment) = (0, 0, 0, 0);
        foreach (FineShape shape in Shapes)
        {
            (double area, double cx, double cy, double second) = shape.Integrals();
            mass += shape.Density * area;
            x += shape.Density * area * cx;
            y += shape.Density * area * cy;
            moment += shape.Density * second;
        }

        if (mass > 0)
        {
            (LocalX, LocalY) = (x / mass, y / mass);
            InverseMass = 1 / mass;
            InverseInertia = 1 / (moment - (mass * ((LocalX * LocalX) + (LocalY * LocalY))));
            MoveTo(originX, originY, Angle);
        }
    }
}
