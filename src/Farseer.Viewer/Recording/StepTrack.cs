using System;

namespace FarseerGames.FarseerPhysics.Viewer.Recording;

/// <summary>What is said of a whole update: its time, the hash of the state, and the accuracy report.</summary>
internal sealed class StepTrack
{
    public const int HashHigh = 2;
    public const int HashLow = 3;

    private const int Time = 0;
    private const int Dt = 1;
    private const int Bodies = 4;
    private const int Asleep = 5;
    private const int GravityX = 6;
    private const int GravityY = 7;
    private const int Reported = 8;

    private static readonly ColumnSpec[] _own =
    {
        new ColumnSpec("time", ColumnKind.Double),
        new ColumnSpec("dt", ColumnKind.Single),
        new ColumnSpec("hashHigh", ColumnKind.Integer),
        new ColumnSpec("hashLow", ColumnKind.Integer),
        new ColumnSpec("bodies", ColumnKind.Integer),
        new ColumnSpec("asleep", ColumnKind.Integer),
        new ColumnSpec("gravityX", ColumnKind.Single),
        new ColumnSpec("gravityY", ColumnKind.Single),
        new ColumnSpec("reported", ColumnKind.Byte),
    };

    private static readonly Figure[] _figures =
    {
        new Figure("error", static r => r.Error),
        new Figure("constraintError", static r => r.ConstraintError),
        new Figure("motionError", static r => r.MotionError),
        new Figure("errorShare", static r => r.ErrorShare),
        new Figure("budgetLoad", static r => r.BudgetLoad),
        new Figure("iterations", static r => r.Iterations),
        new Figure("mostIterations", static r => r.MostIterations),
        new Figure("contacts", static r => r.Contacts),
        new Figure("largestPenetration", static r => r.LargestPenetration),
        new Figure("rmsPenetration", static r => r.RmsPenetration),
        new Figure("residualContactSpeed", static r => r.ResidualContactSpeed),
        new Figure("joints", static r => r.Joints),
        new Figure("largestSeparation", static r => r.LargestSeparation),
        new Figure("rmsSeparation", static r => r.RmsSeparation),
        new Figure("largestTurn", static r => r.LargestTurn),
        new Figure("residualJointSpeed", static r => r.ResidualJointSpeed),
        new Figure("largestSlip", static r => r.LargestSlip),
        new Figure("largestCreep", static r => r.LargestCreep),
        new Figure("largestImpactError", static r => r.LargestImpactError),
        new Figure("impactEnergyError", static r => r.ImpactEnergyError),
        new Figure("kineticEnergy", static r => r.KineticEnergy),
        new Figure("kineticEnergyChange", static r => r.KineticEnergyChange),
        new Figure("gravityWork", static r => r.GravityWork),
        new Figure("forceWork", static r => r.ForceWork),
        new Figure("contactWork", static r => r.ContactWork),
        new Figure("jointWork", static r => r.JointWork),
        new Figure("energyError", static r => r.EnergyError),
        new Figure("momentumError", static r => r.MomentumError),
        new Figure("worstIslandBodies", static r => r.WorstIslandBodies),
        new Figure("cause", static r => (int)r.Cause),
    };

    private readonly int _worstBody = _own.Length + _figures.Length;

    public StepTrack()
    {
        ColumnSpec[] columns = new ColumnSpec[_worstBody + 3];
        _own.CopyTo(columns, 0);
        for (int i = 0; i < _figures.Length; i++)
        {
            columns[_own.Length + i] = new ColumnSpec(_figures[i].Name, ColumnKind.Double);
        }

        columns[_worstBody] = new ColumnSpec("worstBody", ColumnKind.Integer);
        columns[_worstBody + 1] = new ColumnSpec("worstPartner", ColumnKind.Integer);
        columns[_worstBody + 2] = new ColumnSpec("worstJoint", ColumnKind.Integer);
        Track = new Track("step", columns);
    }

    public Track Track { get; }

    public void Record(PhysicsSimulator simulator, double time, float dt, BodyTrack bodies, LinkTrack links)
    {
        Track.Begin(1);
        ulong hash = simulator.MotionHash();
        Track.Set(0, Time, time);
        Track.Set(0, Dt, dt);
        Track.Set(0, HashHigh, unchecked((int)(hash >> 32)));
        Track.Set(0, HashLow, unchecked((int)hash));
        Track.Set(0, Bodies, simulator.BodyList.Count);
        Track.Set(0, Asleep, simulator.SleepingBodyCount);
        Track.Set(0, GravityX, simulator.Gravity.X);
        Track.Set(0, GravityY, simulator.Gravity.Y);

        StepReport report = simulator.Report;
        bool isReported = report.Iterations > 0 && (simulator.EnableReport || simulator.ErrorBudget.IsBounded);
        Track.Set(0, Reported, isReported ? 1 : 0);
        for (int i = 0; i < _figures.Length; i++)
        {
            Track.Set(0, _own.Length + i, isReported ? _figures[i].Read(report) : 0);
        }

        Track.Set(0, _worstBody, isReported ? bodies.Find(report.WorstBody) : -1);
        Track.Set(0, _worstBody + 1, isReported ? bodies.Find(report.WorstPartner) : -1);
        Track.Set(0, _worstBody + 2, isReported ? links.Find(report.WorstJoint) : -1);
    }

    private readonly struct Figure
    {
        public Figure(string name, Func<StepReport, double> read)
        {
            Name = name;
            Read = read;
        }

        public string Name { get; }

        public Func<StepReport, double> Read { get; }
    }
}
