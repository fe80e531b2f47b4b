using System;
using System.Numerics;
using Farseer.Engine.Bodies;
using Farseer.Engine.Contacts;
using Farseer.Engine.Graph;
using Farseer.Engine.Storage;

namespace Farseer.Engine.Islands;

/// <summary>
/// The impulses with which a small island of level contacts would rest, solved for directly. Passes over the contacts take as many
/// sweeps as a box is lighter than what stands on it until they find the load, and meanwhile it is squeezed: 1:10⁴ sank by 83 mm,
/// and with twice the iterations the box was thrown out. Given once, when a resting island begins without any impulse; the passes go on from there.
/// </summary>
internal sealed unsafe class StartingLoads
{
    /// <summary>Contacts of the largest island: its matrix has twice as many rows, and is solved within 0.2 ms.</summary>
    private const int MostContacts = 32;

    /// <summary>Cosine to gravity from which on a contact is level: a steeper one needs its friction, which is not solved for.</summary>
    private const float LeastSteepness = 0.99f;

    /// <summary>
    /// Softness that makes loads on more supports than needed definite. An error of this share times the ratio of the masses is what it
    /// costs, and rounding starts four digits below.
    /// </summary>
    private const double Softness = 1e-12;

    /// <summary>Points found to pull are left out, and the others solved for again, so many times at most.</summary>
    private const int Rounds = 8;

    private readonly Column<Entry> _entries = new Column<Entry>();
    private readonly Column<Point> _points = new Column<Point>();
    private readonly Column<int> _heads = new Column<int>();
    private double* _matrix;
    private readonly double[] _load = new double[2 * MostContacts];
    private int _count;

    /// <summary>Forgets the contacts of the last time.</summary>
    public void Begin(int islands, Scratch scratch)
    {
        _matrix = scratch.Take<double>(2 * MostContacts * 2 * MostContacts);
        _heads.EnsureCapacity(Math.Max(islands, 1));
        for (int i = 0; i < islands; i++)
        {
            _heads[i] = -1;
        }

        _count = 0;
    }

    public void Add(int island, ContactBundle* bundle, int lane)
    {
        _entries.EnsureCapacity(_count + 1);
        _entries[_count] = new Entry { Bundle = bundle, Lane = lane, Next = _heads[island] };
        _heads[island] = _count++;
    }

    /// <summary>Gives the contacts of an island their impulses, if all are level and without any.</summary>
    /// <param name="island">The island.</param>
    /// <param name="bodies">The store.</param>
    /// <param name="gravity">Gravity of the world.</param>
    /// <param name="c">Of the step's own substep.</param>
    public void Give(int island, BodyStore bodies, Vector2 gravity, in ContactCoefficients c)
    {
        int count = Collect(island, bodies, gravity, c);
        if (count == 0 || !Solve(count))
        {
            return;
        }

        for (int i = 0; i < count; i++)
        {
            ref Point point = ref _points[i];
            ContactPointLanes* lanes = point.Second ? &point.Bundle->Point1 : &point.Bundle->Point0;
            float load = (float)_load[i];
            lanes->Normal[point.Lane] = load;
            lanes->PreviousNormal[point.Lane] = load;
        }

        // All of it is fed forward, so that nothing sinks at first, and swings; what is to be left of the sag comes with the island's own
        // pace. That follows from the loads, and was found in this step before there were any.
        for (int i = 0; i < count; i++)
        {
            ref Point point = ref _points[i];
            ContactBundle* bundle = point.Bundle;
            int lane = point.Lane;
            float shared = bundle->Point0.Normal[lane];
            shared = (bundle->Flags[lane] & ContactBundle.SingleMark) != 0 ? shared : Math.Min(shared, bundle->Point1.Normal[lane]);
            ContactPointLanes* lanes = point.Second ? &bundle->Point1 : &bundle->Point0;
            lanes->Feed[lane] = shared;
            bundle->FeedRate[lane] = 0;
        }
    }

    /// <returns>How many points the island has; 0: it is not one to be given loads.</returns>
    private int Collect(int island, BodyStore bodies, Vector2 gravity, in ContactCoefficients c)
    {
        int count = 0;
        for (int k = _heads[island]; k >= 0; k = _entries[k].Next)
        {
            ref Entry entry = ref _entries[k];
            ContactBundle* bundle = entry.Bundle;
            int lane = entry.Lane;
            float steep = Math.Abs((bundle->NormalX[lane] * gravity.X) + (bundle->NormalY[lane] * gravity.Y));
            if (count + 2 > 2 * MostContacts || steep < LeastSteepness * c.Gravity || bundle->Point0.Normal[lane] + bundle->Point1.Normal[lane] != 0)
            {
                return 0;
            }

            // The points of a contact that is still open, or that does not exist, carry nothing.
            Vector2 fall = (Fall(bodies, bundle->BodyB[lane], bundle->MassB[lane], gravity)
                - Fall(bodies, bundle->BodyA[lane], bundle->MassA[lane], gravity)) * c.Substep;
            float approach = (bundle->NormalX[lane] * fall.X) + (bundle->NormalY[lane] * fall.Y);
            _points.EnsureCapacity(count + 2);
            AddPoint(ref count, bundle, lane, second: false, approach);
            if ((bundle->Flags[lane] & ContactBundle.SingleMark) == 0)
            {
                AddPoint(ref count, bundle, lane, second: true, approach);
            }
        }

        return count;
    }

    private static Vector2 Fall(BodyStore bodies, int body, float inverseMass, Vector2 gravity) =>
        inverseMass > 0 && (bodies.Flags[body] & BodyFlags.IgnoreGravity) == 0 ? gravity : Vector2.Zero;

    private void AddPoint(ref int count, ContactBundle* bundle, int lane, bool second, float approach)
    {
        ContactPointLanes* point = second ? &bundle->Point1 : &bundle->Point0;
        _points[count++] = new Point
        {
            Bundle = bundle,
            Lane = lane,
            Second = second,
            Pushes = true,
            ArmA = point->TangentArmA[lane],
            ArmB = point->TangentArmB[lane],
            Approach = approach,
        };
    }

    /// <summary>What the impulse of the second point changes in the approach of the first.</summary>
    private static double Response(in Point p, in Point q)
    {
        double cosine = ((double)p.Bundle->NormalX[p.Lane] * q.Bundle->NormalX[q.Lane]) + ((double)p.Bundle->NormalY[p.Lane] * q.Bundle->NormalY[q.Lane]);
        int a = p.Bundle->BodyA[p.Lane];
        int b = p.Bundle->BodyB[p.Lane];
        double sum = 0;
        if (q.Bundle->BodyA[q.Lane] == a)
        {
            sum += Share(p.Bundle->MassA[p.Lane], p.Bundle->InertiaA[p.Lane], cosine, p.ArmA, q.ArmA);
        }
        else if (q.Bundle->BodyB[q.Lane] == a)
        {
            sum -= Share(p.Bundle->MassA[p.Lane], p.Bundle->InertiaA[p.Lane], cosine, p.ArmA, q.ArmB);
        }

        if (q.Bundle->BodyB[q.Lane] == b)
        {
            sum += Share(p.Bundle->MassB[p.Lane], p.Bundle->InertiaB[p.Lane], cosine, p.ArmB, q.ArmB);
        }
        else if (q.Bundle->BodyA[q.Lane] == b)
        {
            sum -= Share(p.Bundle->MassB[p.Lane], p.Bundle->InertiaB[p.Lane], cosine, p.ArmB, q.ArmA);
        }

        return sum;
    }

    private static double Share(double mass, double inertia, double cosine, double arm, double other) => (mass * cosine) + (inertia * arm * other);

    /// <returns>False if the matrix cannot be solved.</returns>
    private bool Solve(int count)
    {
        for (int round = 0; round < Rounds; round++)
        {
            if (!Factor(count))
            {
                return false;
            }

            Substitute(count);
            bool pulls = false;
            for (int i = 0; i < count; i++)
            {
                if (_load[i] < 0)
                {
                    _points[i].Pushes = false;
                    pulls = true;
                }
            }

            if (!pulls)
            {
                return true;
            }
        }

        return false;
    }

    /// <summary>Cholesky factor of the responses of the points that push; the others have a row of their own, with no load.</summary>
    private bool Factor(int count)
    {
        for (int i = 0; i < count; i++)
        {
            ref Point p = ref _points[i];
            for (int j = 0; j <= i; j++)
            {
                bool coupled = p.Pushes && _points[j].Pushes;
                double value = coupled ? Response(p, _points[j]) : i == j ? 1 : 0;
                double sum = i == j ? value * (1 + Softness) : value;
                for (int k = 0; k < j; k++)
                {
                    sum -= _matrix[(i * count) + k] * _matrix[(j * count) + k];
                }

                if (i != j)
                {
                    _matrix[(i * count) + j] = sum / _matrix[(j * count) + j];
                }
                else if (sum > 0)
                {
                    _matrix[(i * count) + i] = Math.Sqrt(sum);
                }
                else
                {
                    return false;
                }
            }
        }

        return true;
    }

    private void Substitute(int count)
    {
        for (int i = 0; i < count; i++)
        {
            double sum = _points[i].Pushes ? -_points[i].Approach : 0;
            for (int k = 0; k < i; k++)
            {
                sum -= _matrix[(i * count) + k] * _load[k];
            }

            _load[i] = sum / _matrix[(i * count) + i];
        }

        for (int i = count - 1; i >= 0; i--)
        {
            double sum = _load[i];
            for (int k = i + 1; k < count; k++)
            {
                sum -= _matrix[(k * count) + i] * _load[k];
            }

            _load[i] = sum / _matrix[(i * count) + i];
        }
    }

    private struct Entry
    {
        public ContactBundle* Bundle;
        public int Lane;
        public int Next;
    }

    private struct Point
    {
        public ContactBundle* Bundle;
        public int Lane;
        public bool Second;

        /// <summary>It carries a share of the load.</summary>
        public bool Pushes;
        public double ArmA;
        public double ArmB;

        /// <summary>Speed at which gravity opens the point in a substep if nothing pushes.</summary>
        public double Approach;
    }
}
