using System;
using Farseer.Engine.Storage;

namespace Farseer.Engine.Accuracy;

/// <summary>
/// How far bodies stand from where they would with exact contacts: what the contacts and joints between a body and the nearest fixed one
/// are off by, summed over the shortest such way. The ten boxes of a stack sink each by its own contact and all below.
/// </summary>
[NotState(Why.OfOneStep)]
internal sealed class SagPaths
{
    /// <summary>Walks over all pairs at most: a way over more than so many bodies is cut off there.</summary>
    private const int MostWalks = 256;

    private readonly Column<Edge> _edges = new Column<Edge>();
    private readonly Column<double> _sag = new Column<double>();
    private int _count;
    private int _end;

    public void Begin(int bodyEnd)
    {
        _count = 0;
        _end = bodyEnd;
        _sag.EnsureCapacity(bodyEnd);
    }

    /// <summary>A pair that is off by <paramref name="error"/>, a length.</summary>
    public void Add(int bodyA, int bodyB, bool movesA, bool movesB, double error)
    {
        _edges.EnsureCapacity(_count + 1);
        _edges[_count++] = new Edge { A = movesA ? bodyA : -1, B = movesB ? bodyB : -1, Error = error };
    }

    /// <summary>Sums up; of a group that nothing holds each body gets the largest error of its own pairs.</summary>
    public void Run()
    {
        for (int i = 0; i < _end; i++)
        {
            _sag[i] = double.PositiveInfinity;
        }

        bool changed = true;
        for (int walk = 0; changed && walk < MostWalks; walk++)
        {
            changed = false;
            for (int i = 0; i < _count; i++)
            {
                Edge edge = _edges[i];
                double a = edge.A >= 0 ? _sag[edge.A] : 0;
                double b = edge.B >= 0 ? _sag[edge.B] : 0;
                if (edge.A >= 0 && b + edge.Error < a)
                {
                    _sag[edge.A] = b + edge.Error;
                    changed = true;
                }

                if (edge.B >= 0 && a + edge.Error < b)
                {
                    _sag[edge.B] = a + edge.Error;
                    changed = true;
                }
            }
        }

        for (int i = 0; i < _end; i++)
        {
            _sag[i] = double.IsPositiveInfinity(_sag[i]) ? 0 : _sag[i];
        }

        for (int i = 0; i < _count; i++)
        {
            Edge edge = _edges[i];
            Raise(edge.A, edge.Error);
            Raise(edge.B, edge.Error);
        }
    }

    /// <summary>
    /// Place and turn of a body, as a length: what its contact is off by moves it, and turns it about its other contacts by as much again.
    /// </summary>
    public double Of(int body) => 2 * _sag[body];

    private void Raise(int body, double error)
    {
        if (body >= 0)
        {
            _sag[body] = Math.Max(_sag[body], error);
        }
    }

    private struct Edge
    {
        public int A;
        public int B;
        public double Error;
    }
}
